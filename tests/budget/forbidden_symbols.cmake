# Fails, naming them, when IMAGE holds functions that the engine promises to do without; EXCEPT is a rule that does not hold for it.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/run.cmake)

# The names are those of the Arm run-time ABI and of libgcc.
string(CONCAT floating_point
  "__aeabi_c?[fd][a-z0-9]*|__aeabi_(i|ui|l|ul)2[fd]|"
  "__(add|sub|mul|div|neg|cmp|unord|eq|ne|lt|le|gt|ge)[sdt]f[23]|"
  "__(extend|trunc)[a-z]f[a-z]f2|__float(un)?[sdt]i[sdt]f|__fix(uns)?[sdt]f[sdt]i|"
  "(sqrt|sin|cos|tan|pow|exp|log|floor|ceil)f?")
set(division_of_64_bits "__aeabi_u?ldivmod|__u?(div|mod|divmod)[dt]i[34]")
set(heap "malloc|free|calloc|realloc|_sbrk|_malloc_r|_free_r|_Zn[wa].*|_Zd[la].*")
set(exceptions "_Unwind_.*|__aeabi_unwind_cpp_pr[012]|__gxx_personality_v0")
set(language_support "__cxa_.*|__aeabi_atexit|atexit|__dso_handle")

shade16_run(symbols ${NM} --format=posix ${IMAGE})
string(REGEX REPLACE "\n" ";" symbols "${symbols}")
list(TRANSFORM symbols REPLACE " .*" "")

set(rules floating_point division_of_64_bits heap exceptions language_support)
list(REMOVE_ITEM rules "${EXCEPT}")
foreach(rule IN LISTS rules)
  set(found ${symbols})
  list(FILTER found INCLUDE REGEX "^(${${rule}})$")
  if(found)
    list(JOIN found ", " names)
    string(REPLACE "_" " " rule "${rule}")
    message(SEND_ERROR "${IMAGE} contains ${rule}: ${names}")
  endif()
endforeach()
