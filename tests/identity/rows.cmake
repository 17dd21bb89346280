# shade16_identity_rows(<text> <rows>): the hashes that a machine printed. Whatever an emulator puts around them is left out.
function(shade16_identity_rows text rows)
  string(REGEX MATCHALL "(kernel [a-z0-9_.]+ [0-9]+|frame [a-z0-9_.]+|large_frame [a-z0-9_.]+) [0-9a-f]+" found "${text}")
  set(${rows} "${found}" PARENT_SCOPE)
endfunction()
