// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_MESH_READING_RESULT_H
#define CGAL_QUAD_MESHING_IO_MESH_READING_RESULT_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/// \ingroup PkgQuadMeshingIORef
/// is how the reading of a mesh ended.
enum class Mesh_reading_status
{
  SUCCESS,            ///< the mesh is there
  CANNOT_OPEN,        ///< the file does not exist or cannot be read
  EMPTY_FILE,         ///< the file has no content
  UNKNOWN_FORMAT,     ///< the extension of the file is not `off`, `obj`, `ply` or `stl`
  MALFORMED_FILE,     ///< the content is not what the format prescribes
  INVALID_INDEX,      ///< a face names a vertex that does not exist
  INVALID_COORDINATE, ///< a coordinate is not a finite number, or too large to compute with
  NO_FACES,           ///< there is no face, or none with an area
  NOT_ORIENTABLE,     ///< the surface has one side only, as a Moebius strip has
  NEEDS_REPAIR        ///< the faces make a mesh only with a repair that was switched off
};

/// \ingroup PkgQuadMeshingIORef
/// returns the name of a status in lower case letters.
inline const char* status_name(Mesh_reading_status status)
{
  switch(status)
  {
    case Mesh_reading_status::SUCCESS: return "success";
    case Mesh_reading_status::CANNOT_OPEN: return "cannot_open";
    case Mesh_reading_status::EMPTY_FILE: return "empty_file";
    case Mesh_reading_status::UNKNOWN_FORMAT: return "unknown_format";
    case Mesh_reading_status::MALFORMED_FILE: return "malformed_file";
    case Mesh_reading_status::INVALID_INDEX: return "invalid_index";
    case Mesh_reading_status::INVALID_COORDINATE: return "invalid_coordinate";
    case Mesh_reading_status::NO_FACES: return "no_faces";
    case Mesh_reading_status::NOT_ORIENTABLE: return "not_orientable";
    case Mesh_reading_status::NEEDS_REPAIR: return "needs_repair";
  }
  return "unknown";
}

/*!
 * \ingroup PkgQuadMeshingIORef
 *
 * \brief is the set of repairs that `read_triangle_mesh()` may make, in the order in which it makes them.
 *
 * A truth value converts to it: `true` switches all repairs on, `false` switches all of them off. A file that needs a
 * repair that is switched off is read as it is if it is a mesh without that repair, and refused otherwise
 * (`Mesh_reading_status::NEEDS_REPAIR`).
 */
struct Mesh_repairs
{
  /// Vertices without a face are dropped; else they become isolated vertices of the mesh.
  bool drop_unused_vertices = true;

  /// Borders of faces that lie at the same place are joined, and sides of faces without length vanish. A border edge
  /// on which vertices of the border lie is split there, if that joins it to the edges between those vertices.
  bool merge_vertices = true;

  /// The largest distance of two vertices at the border that are taken for one, and of a vertex and an edge it is taken
  /// to lie on, as a share of the diagonal of the bounding box. It is never more than a tenth of the shortest side of a
  /// face at either of the two; vertices at exactly one place are merged whatever it is.
  double merging_distance = 1e-6;

  /// Faces with fewer than three distinct vertices are dropped, and of faces that are there more than once, in the same
  /// or in opposite directions, one copy stays.
  bool drop_copies = true;

  /// Triangles of zero area are removed; their middle vertex is inserted into the faces at their longest side.
  bool flatten_faces = true;

  /// Faces are oriented consistently.
  bool orient_faces = true;

  /// Edges with more than two faces are separated into sheets, and vertices at which the surface touches itself are
  /// split.
  bool separate_sheets = true;

  /// switches all repairs on or off.
  Mesh_repairs(bool all = true)
    : drop_unused_vertices(all)
    , merge_vertices(all)
    , drop_copies(all)
    , flatten_faces(all)
    , orient_faces(all)
    , separate_sheets(all)
  {
  }
};

/*!
 * \ingroup PkgQuadMeshingIORef
 *
 * \brief relates the vertices, or the faces, of a mesh to those of the file that it was read from.
 *
 * Elements of the mesh are counted from 0 in the order of its iterators, elements of the file from 0 in the order of
 * the file. A vertex of the file that was split stands for several vertices of the mesh, a polygon for several
 * triangles; vertices that were merged, and copies of a face, stand for one element of the mesh.
 */
class File_numbers
{
  std::size_t m_mesh_size = 0, m_file_size = 0;
  std::vector<std::uint32_t> m_file_number; // per element of the mesh; empty: the same number
  std::vector<std::uint32_t> m_mesh_number; // per element of the file; empty: the same number

  static constexpr std::uint32_t no_number = 0xFFFFFFFF;

public:
  /// is the answer where there is no such element.
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /// no elements.
  File_numbers() = default;

  /// n elements that have the same number in the mesh and in the file.
  explicit File_numbers(std::size_t n) : m_mesh_size(n), m_file_size(n) {}

#ifndef DOXYGEN_RUNNING
  // 0xFFFFFFFF stands for none. Vectors that give every element its own number are not kept.
  File_numbers(std::vector<std::uint32_t> file_number, std::vector<std::uint32_t> mesh_number)
    : m_mesh_size(file_number.size()), m_file_size(mesh_number.size())
  {
    bool is_identity = m_mesh_size == m_file_size;
    for(std::size_t i = 0; i < m_mesh_size && is_identity; ++i)
      is_identity = file_number[i] == i && mesh_number[i] == i;
    if(is_identity)
      return;
    m_file_number = std::move(file_number);
    m_mesh_number = std::move(mesh_number);
  }
#endif

  /// returns the number of elements of the mesh.
  std::size_t mesh_size() const { return m_mesh_size; }

  /// returns the number of elements of the file.
  std::size_t file_size() const { return m_file_size; }

  /// returns whether all elements have the same number in the mesh and in the file.
  bool is_identity() const { return m_file_number.empty() && m_mesh_number.empty(); }

  /// returns the element of the file that element `i` of the mesh stands for, `none` if it was inserted.
  std::size_t file_number(std::size_t i) const { return number(m_file_number, i); }

  /// returns the first element of the mesh that stands for element `i` of the file, `none` if it was dropped.
  std::size_t mesh_number(std::size_t i) const { return number(m_mesh_number, i); }

  /// returns the numbers for a mesh that keeps some elements of this one: its element `i` was `kept[i]`.
  File_numbers of_part(const std::vector<std::size_t>& kept) const
  {
    std::vector<std::uint32_t> file_numbers, mesh_numbers(m_file_size, no_number), new_number(m_mesh_size, no_number);
    for(std::size_t k : kept)
    {
      const std::size_t n = file_number(k);
      new_number[k] = static_cast<std::uint32_t>(file_numbers.size());
      if(n != none && mesh_numbers[n] == no_number)
        mesh_numbers[n] = new_number[k];
      file_numbers.push_back(n == none ? no_number : static_cast<std::uint32_t>(n));
    }
    // Elements of the file that were merged into an element that is kept.
    for(std::size_t n = 0; n < m_file_size; ++n)
      if(mesh_numbers[n] == no_number && mesh_number(n) != none)
        mesh_numbers[n] = new_number[mesh_number(n)];
    return File_numbers(std::move(file_numbers), std::move(mesh_numbers));
  }

private:
  std::size_t number(const std::vector<std::uint32_t>& numbers, std::size_t i) const
  {
    if(is_identity())
      return i;
    return numbers[i] == no_number ? none : static_cast<std::size_t>(numbers[i]);
  }
};

/*!
 * \ingroup PkgQuadMeshingIORef
 *
 * \brief counts what `read_triangle_mesh()` did to make the content of a file a triangle mesh.
 */
struct Mesh_repair_counts
{
  /// vertices of the file that no face names, which were dropped
  std::size_t unused_vertices = 0;
  /// vertices of the file that became one with another vertex
  std::size_t merged_vertices = 0;
  /// border edges that were split at vertices of the border, to close cracks
  std::size_t split_border_edges = 0;
  /// faces of the file with fewer than three distinct vertices, which were dropped
  std::size_t shapeless_faces = 0;
  /// faces of the file that are there already, in the same direction or as the other side, which were dropped
  std::size_t copied_faces = 0;
  /// those among `copied_faces` that were the other side of a face that stayed
  std::size_t other_sides = 0;
  /// faces of fins: small pairs of faces that bound nothing and stand off a surface that is complete without them
  std::size_t fin_faces = 0;
  /// polygons with more than three vertices, which became triangles
  std::size_t triangulated_polygons = 0;
  /// triangles of zero area that were removed
  std::size_t flattened_faces = 0;
  /// faces whose direction was reversed
  std::size_t reversed_faces = 0;
  /// edges with more than two faces, which were separated into sheets
  std::size_t separated_edges = 0;
  /// vertices at which the surface touched itself, which were split
  std::size_t split_vertices = 0;
};

/*!
 * \ingroup PkgQuadMeshingIORef
 *
 * \brief is the result of `read_triangle_mesh()` and of `read_polygon_soup()`.
 */
struct Mesh_reading_result
{
  /// how it ended
  Mesh_reading_status status = Mesh_reading_status::SUCCESS;

  /// the reason in one sentence without the name of the file, empty after success
  std::string message;

  /// what was done to make the content of the file a triangle mesh, and what is left to know about it, one sentence
  /// each
  std::vector<std::string> repairs;

  /// how often it was done
  Mesh_repair_counts counts;

  /// the number of triangles of zero area in the mesh
  std::size_t number_of_degenerate_faces = 0;

  /// the number of border edges that run along another border edge, closer than a tenth of their length and than a
  /// thousandth of the diagonal of the bounding box: the borders of cracks
  std::size_t number_of_crack_edges = 0;

  /// the vertices of the mesh in the numbers of the file; as STL has no numbers, its vertices count in the order in
  /// which their coordinates first occur
  File_numbers vertices;

  /// the faces of the mesh in the numbers of the file
  File_numbers faces;

  /// returns whether the mesh was read.
  bool is_valid() const { return status == Mesh_reading_status::SUCCESS; }

  /// returns whether the mesh was read.
  explicit operator bool() const { return is_valid(); }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_MESH_READING_RESULT_H
