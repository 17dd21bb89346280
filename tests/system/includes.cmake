# Who may include whom. The core: <stdint.h>, <stddef.h> and itself, one way: num <- scene <- target <- pipeline. glsl is a
# user's vocabulary beside the engine: it stands on num alone, and nothing of the engine stands on it.
# Neither the core nor the firmware knows the simulator or GLM.
cmake_minimum_required(VERSION 3.25)

set(layers num scene target pipeline)

# shade16_includes(<file> <result>): the names in its #include lines, with their brackets or quotes.
function(shade16_includes file result)
  file(STRINGS ${file} lines REGEX "^[ \t]*#[ \t]*include")
  list(TRANSFORM lines REPLACE "^[ \t]*#[ \t]*include[ \t]*([<\"][^>\"]*[>\"]).*" "\\1")
  set(${result} "${lines}" PARENT_SCOPE)
endfunction()

set(core ${SOURCE}/core/include)
file(GLOB_RECURSE headers RELATIVE ${core} ${core}/*)
if(NOT headers)
  message(FATAL_ERROR "There is no header under ${core}: this test would pass without looking at anything.")
endif()

foreach(header IN LISTS headers)
  string(REGEX REPLACE "^shade16/([^/]*).*" "\\1" layer "${header}")
  list(FIND layers "${layer}" rank)
  shade16_includes(${core}/${header} includes)
  foreach(include IN LISTS includes)
    if(include MATCHES "^<(stdint|stddef)\\.h>$")
      continue()
    endif()
    if(NOT include MATCHES "^\"shade16/(.*)\"$")
      message(SEND_ERROR
        "${header} includes ${include}. The core includes <stdint.h>, <stddef.h> and \"shade16/...\" only.")
      continue()
    endif()
    string(REGEX REPLACE "^\"shade16/([^/\"]*).*" "\\1" included_layer "${include}")
    list(FIND layers "${included_layer}" included_rank)
    if(layer STREQUAL "glsl" AND NOT included_layer MATCHES "^(glsl|num)$")
      message(SEND_ERROR "${header} includes ${include}, but 'glsl' stands on 'num' alone.")
    elseif(rank GREATER -1 AND included_layer MATCHES "^glsl")
      message(SEND_ERROR "${header} includes ${include}, but the engine does without 'glsl'.")
    elseif(NOT rank EQUAL -1 AND included_rank GREATER rank)
      message(SEND_ERROR "${header} includes ${include}, but '${layer}' comes before '${included_layer}'.")
    endif()
  endforeach()
endforeach()

file(GLOB_RECURSE sources ${SOURCE}/core/*.hpp ${SOURCE}/firmware/*.[ch]pp ${SOURCE}/boards/*.hpp)
list(FILTER sources EXCLUDE REGEX "/boards/linux_spi/")  # a board that is the host
foreach(source IN LISTS sources)
  shade16_includes(${source} includes)
  foreach(include IN LISTS includes)
    if(include MATCHES "host_sim|glm/")
      message(SEND_ERROR "${source} includes ${include}, which belongs to the host.")
    endif()
  endforeach()
endforeach()

# Two references that agree prove something only if they share nothing.
file(GLOB sources ${SOURCE}/host_sim/textbook/*)
if(NOT sources)
  message(FATAL_ERROR "There is nothing under host_sim/textbook: this test would pass without looking at it.")
endif()
foreach(source IN LISTS sources)
  shade16_includes(${source} includes)
  foreach(include IN LISTS includes)
    if(NOT include MATCHES "^<|^\"host_sim/textbook/")
      message(SEND_ERROR "${source} includes ${include}: the textbook shares nothing with the engine or the reference.")
    endif()
  endforeach()
endforeach()
