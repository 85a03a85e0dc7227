// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_READ_SOUP_FILE_IMPL_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_READ_SOUP_FILE_IMPL_H

#include <CGAL/Quad_meshing/IO/internal/read_obj.h>
#include <CGAL/Quad_meshing/IO/internal/read_off.h>
#include <CGAL/Quad_meshing/IO/internal/read_ply.h>
#include <CGAL/Quad_meshing/IO/internal/read_soup_file.h>
#include <CGAL/Quad_meshing/IO/internal/read_stl.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

CGAL_QUAD_MESHING_INLINE std::string file_extension(const std::string& filename)
{
  const std::size_t dot = filename.find_last_of("./\\");
  if(dot == std::string::npos || filename[dot] != '.')
    return std::string();
  std::string extension = filename.substr(dot + 1);
  for(char& c : extension)
    if('A' <= c && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

// All bytes of a file. Returns false, with the system's reason, if it cannot be read.
inline bool read_bytes(const std::string& filename, std::string& bytes, std::string& error)
{
  errno = 0;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(filename.c_str(), "rb"), &std::fclose);
  bool is_good = file != nullptr;
  std::size_t wanted = std::size_t(1) << 20; // bytes, where the size is not known
  if(is_good && std::fseek(file.get(), 0, SEEK_END) == 0)
  {
    // What has a size is read at once; a pipe has none.
    const long size = std::ftell(file.get());
    constexpr long largest_guess = 1L << 30; // bytes; a folder says any size
    if(0 < size && size <= largest_guess)
      wanted = static_cast<std::size_t>(size) + 1;
    std::rewind(file.get());
  }
  errno = is_good ? 0 : errno;
  for(std::size_t n = wanted; is_good && n == wanted;)
  {
    const std::size_t old_size = bytes.size();
    bytes.resize(old_size + wanted);
    n = std::fread(&bytes[old_size], 1, wanted, file.get());
    bytes.resize(old_size + n);
    is_good = std::ferror(file.get()) == 0;
  }
  if(!is_good)
    error = errno != 0 ? std::strerror(errno) : "unknown reason";
  return is_good;
}

// The text behind a byte-order mark, if there is one.
inline std::string_view without_byte_order_mark(std::string_view text)
{
  return text.substr(0, 3) == "\xEF\xBB\xBF" ? text.substr(3) : text;
}

CGAL_QUAD_MESHING_INLINE bool read_soup_file(const std::string& filename, Polygon_soup& soup,
                                             Mesh_reading_result& result, Mesh_attributes* attributes)
{
  auto refuse = [&](Mesh_reading_status status, const std::string& message)
  {
    result.status = status;
    result.message = message;
    return false;
  };

  std::string bytes, error;
  if(!read_bytes(filename, bytes, error))
    return refuse(Mesh_reading_status::CANNOT_OPEN, "The file cannot be read: " + error + ".");
  const std::string extension = file_extension(filename);
  if(extension != "off" && extension != "obj" && extension != "ply" && extension != "stl")
    return refuse(Mesh_reading_status::UNKNOWN_FORMAT,
                  "The format '" + extension + "' is not one of off, obj, ply, stl.");
  const std::string_view text = without_byte_order_mark(bytes);
  if(text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    return refuse(Mesh_reading_status::EMPTY_FILE, "The file is empty.");
  const std::string_view first_two = text.substr(0, 2);
  if(first_two == "\xFF\xFE" || first_two == "\xFE\xFF")
    return refuse(Mesh_reading_status::MALFORMED_FILE, "The file is text in UTF-16, which is not read.");

  Text_scanner in(text);
  if(extension == "off")
    read_off(in, text, soup);
  else if(extension == "obj")
    read_obj(in, text, soup, attributes);
  else if(extension == "ply")
    read_ply(in, text, soup, attributes);
  else
    read_stl(in, text, soup);
  if(in.failed())
    return refuse(in.status(), in.error());
  if(soup.size() == 0)
    return refuse(Mesh_reading_status::NO_FACES, std::string(soup.points.size() == 1 ? "There is " : "There are ") +
                                                   count_of(soup.points.size(), "vertex", "vertices") +
                                                   " but no faces.");
  if(soup.corners.size() >= no_index || soup.points.size() >= no_index)
    return refuse(Mesh_reading_status::MALFORMED_FILE,
                  "There are more corners of faces than can be numbered with 32 bits.");
  return true;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_READ_SOUP_FILE_IMPL_H
