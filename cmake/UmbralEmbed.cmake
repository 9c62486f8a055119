# Defines umbral_embed(): the text of a file as a constant of the program.
#
#   umbral_embed(report assets/page.css assets/plot.js)
#
# adds to the library umbral_report one generated .cpp a file, which defines umbral::assets::page_css and
# umbral::assets::plot_js, each a const std::string_view. A header of the room, assets.h, declares them.
function(umbral_embed room)
  set(script "${PROJECT_SOURCE_DIR}/cmake/embed/embed_file.cmake")
  foreach(file IN LISTS ARGN)
    get_filename_component(name "${file}" NAME)
    string(MAKE_C_IDENTIFIER "${name}" identifier)
    set(input "${CMAKE_CURRENT_SOURCE_DIR}/${file}")
    set(output "${CMAKE_CURRENT_BINARY_DIR}/embedded/${identifier}.cpp")
    add_custom_command(
      OUTPUT "${output}"
      COMMAND ${CMAKE_COMMAND} "-DINPUT=${input}" "-DOUTPUT=${output}" "-DIDENTIFIER=${identifier}"
              "-DHEADER=${room}/assets.h" -P "${script}"
      DEPENDS "${input}" "${script}"
      COMMENT "Embedding ${file}"
      VERBATIM)
    target_sources(umbral_${room} PRIVATE "${output}")
  endforeach()
endfunction()
