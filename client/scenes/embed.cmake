# Writes a source file that holds the scenes: cmake -D OUTPUT=<file> -P embed.cmake -- <scene files>
set(entries "")
math(EXPR last "${CMAKE_ARGC} - 1")
set(is_scene FALSE)
foreach(i RANGE ${last})
  set(argument "${CMAKE_ARGV${i}}")
  if(is_scene)
    get_filename_component(name "${argument}" NAME_WE)
    file(READ "${argument}" text)
    string(APPEND entries "    {\"${name}\", R\"scene(${text})scene\"},\n")
  elseif(argument STREQUAL "--")
    set(is_scene TRUE)
  endif()
endforeach()
file(WRITE "${OUTPUT}" "#include \"client/gallery.h\"

namespace trajan::client {

std::span<const GalleryScene> gallery() {
  static constexpr GalleryScene scenes[] = {
${entries}  };
  return scenes;
}

}  // namespace trajan::client
")
