# What every bare-metal toolchain has in common.
include(${CMAKE_CURRENT_LIST_DIR}/require.cmake)
set(CMAKE_SYSTEM_NAME Generic)

# There is no start-up file yet when CMake tries the compiler, so it must not try to link.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

# Programs come from this computer; libraries and headers never do.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# For code that has no operating system and no library under it.
set(SHADE16_FREESTANDING -ffreestanding -fno-exceptions -fno-unwind-tables -fno-asynchronous-unwind-tables -ffunction-sections -fdata-sections)
set(SHADE16_FREESTANDING_CXX -fno-rtti -fno-threadsafe-statics)
