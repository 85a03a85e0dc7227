// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SYMMETRIC_QUADRANGULATION_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SYMMETRIC_QUADRANGULATION_H

#include <CGAL/Quad_meshing/Guides/mirror_triangles.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Mirrored_input.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Mirrored_quads.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Surface_components.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_defects.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>
#include <CGAL/Quad_meshing/internal/surface_topology.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A quadrangulation that is symmetric to planes: one half of the surface, or a quarter or an eighth, is meshed, with
// the cuts as features, and mirrored.
class Symmetric_quadrangulation
{
  typedef Quadrangulation_mesh Mesh;
  typedef Quadrangulation_status Status;

public:
  Symmetric_quadrangulation(const Triangle_input& input, const Quadrangulation_options& options)
    : m_input(input), m_options(options)
  {
  }

  // Returns false, with an answer, if there is nothing to be cut: the surface is not symmetric, or is no surface.
  bool prepare(Quadrangulation_result& result)
  {
    Surface_components components(m_input, Element_names(m_options));
    if(!components.error.empty())
      return refuse(result, Status::INVALID_INPUT, components.error);
    for(const auto& s : components.surfaces)
    {
      m_area += Polygon_mesh_processing::area(s->mesh);
      m_whole += s->mesh;
    }
    m_surfaces = std::move(components.surfaces);
    m_topology = surface_topology(m_whole);
    Bbox_3 box;
    for(const auto& p : m_input.points)
      box += p.bbox();
    m_diagonal = std::sqrt(std::pow(box.x_span(), 2) + std::pow(box.y_span(), 2) + std::pow(box.z_span(), 2));
    const Guided_triangles surface = used_triangles();
    for(const Symmetry_plane& plane : m_options.symmetry_planes)
    {
      if(plane.kind != Symmetry_plane::Kind::FOUND && !(plane.normal.squared_length() > 0))
        return refuse(result, Status::INVALID_INPUT, "The normal of a plane of symmetry is zero.");
      m_mirrors.push_back(make_mirror(surface, plane));
      const double deviation = mirror_deviation(surface, m_mirrors.back());
      if(!(deviation <= m_options.symmetry_tolerance * m_diagonal))
        return refuse(result, Status::REFUSED,
                      "The surface is not symmetric to the plane with the normal " + text(m_mirrors.back().normal()) +
                        ": a vertex is mirrored to a place " + text(deviation) + " off the surface, " +
                        text(100 * deviation / m_diagonal) + " percent of the diagonal; " +
                        text(100 * m_options.symmetry_tolerance) + " are tolerated.");
    }
    const double right_angle = 1e-6; // the cosine of an angle that differs from it by less
    for(std::size_t i = 0; i < m_mirrors.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
        if(std::abs(m_mirrors[i].normal() * m_mirrors[j].normal()) > right_angle)
          return refuse(result, Status::REFUSED, "Two planes of symmetry are not orthogonal to each other.");
    return cut(result);
  }

  const Triangle_input& part() const { return m_part; }
  const Quadrangulation_options& part_options() const { return m_part_options; }

  // How many images the part has, itself included.
  std::size_t copies() const { return std::size_t(1) << m_mirrors.size(); }

  // Makes the whole of the quads of a part.
  void complete(Quadrangulation_result& result, std::unique_ptr<Quadrangulation_quads>& quads)
  {
    result.input_faces = m_input.triangles.size();
    result.components = m_surfaces.size();
    if(quads->mesh.number_of_faces() == 0)
      return;
    const double tolerance = 1e-6 * m_diagonal;
    for(std::size_t i = m_mirrors.size(); i-- > 0;)
    {
      std::unique_ptr<Quadrangulation_quads> both = with_mirror_image(*quads, m_mirrors[i], tolerance);
      if(!both)
      {
        result.status = Status::NOT_VALID;
        result.is_as_requested = false;
        result.message = "The mesh and its mirror image cannot be joined in the plane of symmetry.";
        return;
      }
      quads = std::move(both);
    }
    locate(*quads);
    result.quads *= copies();
    result.other_faces *= copies();
    result.folded_quads *= copies();
    result.irregular_vertices = 0;
    for(Mesh::Vertex_index v : quads->mesh.vertices())
      result.irregular_vertices += quads->mesh.degree(v) != (quads->mesh.is_border(v) ? 3 : 4);
    if(!result.is_valid())
      return;
    std::string defect;
    for(const std::string& reason : defects(quads->mesh))
      defect += (defect.empty() ? "" : ", ") + reason;
    if(defect.empty() && surface_topology(quads->mesh) != m_topology)
      defect = "The topology of the quad mesh is not that of the input";
    if(defect.empty())
      return;
    result.status = Status::NOT_VALID;
    result.is_as_requested = false;
    result.message = defect + ".";
  }

private:
  static bool refuse(Quadrangulation_result& result, Status status, const std::string& message)
  {
    result.status = status;
    result.message = message;
    return false;
  }

  static std::string text(double x)
  {
    std::ostringstream os;
    os.precision(3);
    os << x;
    return os.str();
  }

  static std::string text(const Mirror::Vector_3& v)
  {
    return "(" + text(v.x()) + ", " + text(v.y()) + ", " + text(v.z()) + ")";
  }

  // Without points that no triangle has.
  Guided_triangles used_triangles() const
  {
    Guided_triangles t;
    for(Mesh::Vertex_index v : m_whole.vertices())
      t.points.push_back(m_whole.point(v));
    for(Mesh::Face_index f : m_whole.faces())
    {
      std::array<int, 3> corners;
      int k = 0;
      for(Mesh::Vertex_index v : m_whole.vertices_around_face(m_whole.halfedge(f)))
        corners[k++] = static_cast<int>(v);
      t.triangles.push_back(corners);
    }
    return t;
  }

  bool cut(Quadrangulation_result& result)
  {
    // What is so near to a plane lies in it, in target edge lengths: triangles that are cut get no needles.
    const double snap = 0.01;
    const double length = m_options.target_edge_length > 0 ? m_options.target_edge_length
                                                           : std::sqrt(m_area / m_options.target_number_of_quads);
    m_part = m_input;
    m_part_options = m_options;
    m_part_options.symmetry_planes.clear();
    m_part_options.face_name = [this](std::size_t i) { return Element_names(m_options).face(m_part.original(i)); };
    for(const Mirror& mirror : m_mirrors)
    {
      const Mirror_half half = cut_half(guided_triangles(m_part), mirror, snap * length);
      if(!half.error.empty())
        return refuse(result, Status::REFUSED, half.error);
      m_part = half_of_input(m_part, half);
      const Mirrored_guides guides(mirror);
      const std::string crossing = guides.crossing(m_part_options);
      if(!crossing.empty())
        return refuse(result, Status::REFUSED, crossing);
      guides.apply(m_part_options);
    }
    double area = 0;
    for(const std::array<int, 3>& t : m_part.triangles)
      area +=
        std::sqrt(Quadrangulation_kernel::Triangle_3(m_part.points[t[0]], m_part.points[t[1]], m_part.points[t[2]])
                    .squared_area());
    m_part_options.target_number_of_quads *= area / m_area;
    return true;
  }

  static std::vector<std::string> defects(const Mesh& mesh)
  {
    std::vector<Quadrangulation_kernel::Point_3> points;
    std::vector<std::vector<std::size_t>> polygons;
    Polygon_mesh_processing::polygon_mesh_to_polygon_soup(mesh, points, polygons);
    return find_quad_mesh_defects(points, polygons).reasons();
  }

  // On the whole input.
  void locate(Quadrangulation_quads& quads) const
  {
    typedef AABB_face_graph_triangle_primitive<Mesh> Primitive;
    const AABB_tree<Aabb_traits<Quadrangulation_kernel, Primitive>> tree(faces(m_whole).first, faces(m_whole).second,
                                                                         m_whole);
    std::vector<std::size_t> origin;
    for(const auto& s : m_surfaces)
      for(Mesh::Face_index f : s->mesh.faces())
        origin.push_back(s->origin[f]);
    for(Mesh::Vertex_index v : quads.mesh.vertices())
      quads.input_face[v] = origin[tree.closest_point_and_primitive(quads.mesh.point(v)).second];
  }

  const Triangle_input& m_input;
  const Quadrangulation_options& m_options;
  std::vector<std::unique_ptr<Quadrangulation_surface>> m_surfaces;
  Mesh m_whole;
  double m_area = 0, m_diagonal = 0;
  std::vector<Component_topology> m_topology;
  std::vector<Mirror> m_mirrors;
  Triangle_input m_part;
  Quadrangulation_options m_part_options;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SYMMETRIC_QUADRANGULATION_H
