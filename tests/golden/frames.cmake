# shade16_frames(<app> <board> <printed> <rows>): the lines "frame <n> <hash>" as rows of frames.txt. The rest is talk.
function(shade16_frames app board printed rows)
  string(REGEX MATCHALL "frame [0-9]+ [0-9a-f]+" frames "${printed}")
  list(TRANSFORM frames REPLACE "^frame" "${app} ${board}")
  set(${rows} "${frames}" PARENT_SCOPE)
endfunction()
