# shade16_use_gnu_tools(<gcc>): Clang for a processor that GCC serves as well, linked by lld. Debian has no compiler library for bare metal
# but GCC's, and its multiplication and division are what Clang calls: SHADE16_GCC is asked for it (firmware/app_for_board.cmake).
include(${CMAKE_CURRENT_LIST_DIR}/clang.cmake)
shade16_require(SHADE16_LLD lld ld.lld)
set(CMAKE_EXE_LINKER_FLAGS_INIT -fuse-ld=lld)

macro(shade16_use_gnu_tools gcc)
  set(SHADE16_GCC ${gcc})
  string(REGEX REPLACE "gcc$" "" gnu_prefix ${gcc})
  foreach(tool IN ITEMS AR RANLIB NM OBJCOPY OBJDUMP READELF)
    string(TOLOWER ${tool} name)
    set(CMAKE_${tool} ${gnu_prefix}${name})
  endforeach()
endmacro()
