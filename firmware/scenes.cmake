# One app a baked scene, scene_<name>; none has a board's screen, so on this computer one program is enough. Needs
# app_for_board.cmake or app_for_host.cmake.
set(SHADE16_SCENES_DIR ${PROJECT_SOURCE_DIR}/assets/scenes)

# shade16_scene_program(<target> <scene> [<tier> [<format>]]): without a tier and a pixel format the scene's own.
function(shade16_scene_program target scene)
  shade16_build_scene(${target} ${CMAKE_CURRENT_SOURCE_DIR}/apps/scene.cpp)
  target_compile_definitions(${target} PRIVATE
    SHADE16_SCENE=${scene} SHADE16_SCENE_HEADER="assets/scenes/${scene}.hpp")
  if(ARGC GREATER 2)
    target_compile_definitions(${target} PRIVATE SHADE16_TIER=shade16::${ARGV2})
  endif()
  if(ARGC GREATER 3)
    target_compile_definitions(${target} PRIVATE "SHADE16_FORMAT=shade16::${ARGV3}")
  endif()
endfunction()

file(GLOB scenes CONFIGURE_DEPENDS ${SHADE16_SCENES_DIR}/*.hpp)
foreach(header IN LISTS scenes)
  cmake_path(GET header STEM scene)
  set_property(GLOBAL APPEND PROPERTY SHADE16_SCENES ${scene})
  shade16_scene_program(scene_${scene} ${scene})
  # The benchmark scenes in the other tiers, for whoever asks for them by name.
  if(scene MATCHES "^s[1-6]$")
    foreach(tier IN ITEMS lowp highp)
      shade16_scene_program(scene_${scene}_${tier} ${scene} ${tier})
      set_target_properties(scene_${scene}_${tier} PROPERTIES EXCLUDE_FROM_ALL ON)
    endforeach()
    # And on grey and dithering targets, for docs/performance.md.
    foreach(format IN ITEMS Gray8 Gray4 "Dithered<shade16::Gray4, shade16::bayer4>" "Dithered<shade16::Rgb565, shade16::bayer4>")
      string(REGEX REPLACE "[<>, :]+" "_" name "${format}")
      string(REGEX REPLACE "shade16_|bayer|_$" "" name "${name}")
      string(TOLOWER "${name}" name)
      shade16_scene_program(scene_${scene}_${name} ${scene} mediump "${format}")
      set_target_properties(scene_${scene}_${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    endforeach()
  endif()
endforeach()
