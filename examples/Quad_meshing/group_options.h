// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXAMPLES_GROUP_OPTIONS_H
#define CGAL_QUAD_MESHING_EXAMPLES_GROUP_OPTIONS_H

// The option --groups of the program quadrangulate: groups, materials, texture coordinates and colors of IN guide the
// quads and are carried over to OUT.

#include "command_line.h"

#include <CGAL/Quad_meshing/IO/Attributes_on_mesh.h>
#include <CGAL/Quad_meshing/IO/find_attribute_borders.h>
#include <CGAL/Quad_meshing/IO/read_mesh_attributes.h>
#include <CGAL/Quad_meshing/IO/write_obj.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation.h>
#include <CGAL/Quad_meshing/Quad_mesh/transfer_values.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace group_options {

namespace QM = CGAL::Quad_meshing;
typedef QM::Quadrangulation Quadrangulation;
typedef Quadrangulation::Mesh Mesh;

inline void add(po::options_description& options)
{
  options.add_options()(
    "groups", po::value<std::string>()->implicit_value("groups,materials,seams,normals"),
    "make borders between groups and materials of IN, texture seams and split normals chains of quad "
    "edges, and keep groups, materials, texture coordinates and colors in OUT (OBJ); --groups=LIST "
    "with some of groups,materials,seams,normals makes only those borders edges");
}

inline QM::Attribute_border_kinds read_kinds(const std::string& list)
{
  QM::Attribute_border_kinds kinds;
  const std::array<std::pair<std::string, bool*>, 4> words = { { { "groups", &kinds.groups },
                                                                 { "materials", &kinds.materials },
                                                                 { "seams", &kinds.seams },
                                                                 { "normals", &kinds.normals } } };
  for(const auto& w : words)
    *w.second = false;
  std::istringstream in(list);
  for(std::string word; std::getline(in, word, ',');)
  {
    const auto found = std::find_if(words.begin(), words.end(), [&](const auto& w) { return w.first == word; });
    if(found == words.end())
      throw command_line::Unusable_input("--groups must be a list of groups, materials, seams, normals, not '" + list +
                                         "'");
    *found->second = true;
  }
  return kinds;
}

// The attributes of the input, and their way to the output.
class Groups
{
  typedef QM::Obj_content<Mesh> Content;

public:
  // Gives the quadrangulation its curves. `tm` and `reading` must stay as they are.
  Groups(const command_line::Arguments& args, const Mesh& tm, const QM::Mesh_reading_result& reading,
         Quadrangulation& q)
    : m_tm(tm)
  {
    const QM::Attribute_border_kinds kinds = read_kinds(args.value<std::string>("groups"));
    const QM::Mesh_reading_result result = QM::read_mesh_attributes(args.positional(0), m_attributes);
    if(!result)
      throw command_line::Unusable_input(args.positional(0) + ": " + result.message);
    m_on_mesh = std::make_unique<QM::Attributes_on_mesh<Mesh>>(tm, reading, m_attributes);
    std::map<Mesh::Edge_index, bool> is_border;
    const QM::Attribute_borders borders =
      QM::find_attribute_borders(tm, *m_on_mesh, boost::make_assoc_property_map(is_border), kinds);
    std::cerr << args.positional(0) << ": " << command_line::count_of(borders.edges, "edge lies", "edges lie")
              << " on borders: " << borders.groups << " of groups, " << borders.materials << " of materials, "
              << borders.seams << " on texture seams, " << borders.normals << " with split normals."
              << (borders.has_flat_shading ? " Normals are those of faces and say nothing about edges." : "") << "\n";
    if(borders.edges > 0)
      q.set_curve_edges(tm, boost::make_assoc_property_map(is_border));
    // Texture coordinates are continuous elsewhere, whatever is followed.
    QM::Attribute_border_kinds seams;
    seams.groups = seams.materials = seams.normals = false;
    QM::find_attribute_borders(tm, *m_on_mesh, boost::make_assoc_property_map(m_is_seam), seams);
  }

  // Writes the quads with all that can be carried over, in the format OBJ.
  void write(const std::string& filename, const Quadrangulation& q, int digits) const
  {
    const Mesh& qm = q.quads().mesh;
    Content content;
    content.material_libraries = m_attributes.material_libraries;
    std::map<Mesh::Face_index, Mesh::Face_index> below;
    QM::transfer_face_values(m_tm, CGAL::Identity_property_map<Mesh::Face_index>(), qm,
                             boost::make_assoc_property_map(below));
    auto carry = [&](const QM::Face_names& names, Content::Names& carried)
    {
      carried.names = names.names;
      if(!names.is_empty())
        carried.number = [&](Mesh::Face_index f) { return m_on_mesh->name(below.at(f), names); };
    };
    carry(m_attributes.objects, content.objects);
    carry(m_attributes.groups, content.groups);
    carry(m_attributes.materials, content.materials);
    const std::map<Mesh::Halfedge_index, std::array<double, 3>> texture = carry_texture(qm);
    if(!m_attributes.texture_coordinates.empty())
      content.texture = [&](Mesh::Halfedge_index h) -> std::optional<std::array<double, 2>>
      {
        const std::array<double, 3>& t = texture.at(h);
        if(t[2] < 1) // next to triangles that have none
          return std::nullopt;
        return std::array<double, 2>{ { t[0], t[1] } };
      };
    const std::map<Mesh::Vertex_index, std::array<double, 3>> color = carry_colors(q);
    if(!color.empty())
      content.color = [&](Mesh::Vertex_index v) { return color.at(v); };
    std::ofstream out = command_line::open_output(filename);
    out.precision(digits);
    QM::write_obj(out, qm, content);
    out.close();
    if(!out)
      throw command_line::Unusable_input(filename + ": writing failed");
  }

private:
  // Texture coordinates per corner, and the part of their triangle that has any.
  std::map<Mesh::Halfedge_index, std::array<double, 3>> carry_texture(const Mesh& qm) const
  {
    std::map<Mesh::Halfedge_index, std::array<double, 3>> of_triangles, of_quads;
    if(m_attributes.texture_coordinates.empty())
      return of_quads;
    for(Mesh::Halfedge_index h : m_tm.halfedges())
    {
      const auto t = m_tm.is_border(h) ? std::nullopt : m_on_mesh->texture(h);
      of_triangles[h] = t ? std::array<double, 3>{ { (*t)[0], (*t)[1], 1 } } : std::array<double, 3>{ { 0, 0, 0 } };
    }
    QM::transfer_corner_values(m_tm, boost::make_assoc_property_map(m_is_seam),
                               boost::make_assoc_property_map(of_triangles), qm,
                               boost::make_assoc_property_map(of_quads));
    const double rounding = 1e-9;
    for(auto& t : of_quads)
      t.second[2] = t.second[2] > 1 - rounding ? 1 : 0;
    return of_quads;
  }

  std::map<Mesh::Vertex_index, std::array<double, 3>> carry_colors(const Quadrangulation& q) const
  {
    std::map<Mesh::Vertex_index, std::array<double, 3>> of_triangles, of_quads;
    for(Mesh::Vertex_index v : m_tm.vertices())
      if(const auto c = m_on_mesh->color(v))
        of_triangles[v] = *c;
    if(of_triangles.size() != m_tm.number_of_vertices())
      return of_quads;
    const Mesh& qm = q.quads().mesh;
    const std::vector<Mesh::Face_index> faces(m_tm.faces().begin(), m_tm.faces().end());
    std::map<Mesh::Vertex_index, std::pair<Mesh::Face_index, std::array<double, 3>>> location;
    for(Mesh::Vertex_index v : qm.vertices())
    {
      const auto l = q.location_on_input(v);
      location[v] = std::make_pair(faces[l.first], l.second);
    }
    QM::transfer_vertex_values(m_tm, boost::make_assoc_property_map(of_triangles), qm,
                               boost::make_assoc_property_map(location), boost::make_assoc_property_map(of_quads));
    return of_quads;
  }

  const Mesh& m_tm;
  QM::Mesh_attributes m_attributes;
  std::unique_ptr<QM::Attributes_on_mesh<Mesh>> m_on_mesh;
  std::map<Mesh::Edge_index, bool> m_is_seam;
};

} // namespace group_options

#endif // CGAL_QUAD_MESHING_EXAMPLES_GROUP_OPTIONS_H
