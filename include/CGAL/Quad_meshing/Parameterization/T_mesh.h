// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_T_MESH_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_T_MESH_H

#include <CGAL/Quad_meshing/Parameterization/internal/Seamless_charts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

namespace internal {
class T_mesh_builder;
}

/*!
\ingroup PkgQuadMeshingParameterizationRef

\brief The T-mesh of a seamless map: a partition of a surface into rectangles with T-vertices.

Its arcs are the lines of the motorcycle graph of the map, cut where they meet: from each irregular vertex, each end and
corner of feature curves, and each node of the user, lines run along the axes of the map until they meet another arc.
Features and borders are arcs from the beginning. Every patch is a rectangle of the map; along a side, other patches may
end in T-vertices. All decisions are exact; so are the lengths.

A direction of an arc is a number: `2 * arc` from its source to its target, `2 * arc + 1` back.

References: Eppstein, Goodrich, Kim and Tamstorf, "Motorcycle graphs: canonical quad mesh partitioning" (2008); Campen,
Bommes and Kobbelt, "Quantized global parametrization" (2015).

\sa `Seamless_map::t_mesh()`
\sa `quantize_t_mesh()`
*/
class T_mesh
{
public:
  /// A place on the triangle mesh: the number of a face, and the weights of its corners in the order of
  /// `vertices_around_face(halfedge(f, tm), tm)` that begins with the source.
  typedef std::pair<std::size_t, std::array<double, 3>> Location;

  /// Where arcs meet.
  struct Node
  {
    int vertex = -1; ///< the number of the vertex of the triangle mesh; -1 for a T-vertex inside a triangle
    bool is_critical =
      false; ///< an irregular vertex, a corner, an end or a crossing of features, or a node of the user
    std::vector<int> directions; ///< that leave it, counterclockwise; at the border from the first to the last
    std::vector<int> headings;   ///< of these: right angles from the first
    int right_angles = 4;        ///< around it, in the map; on the border, between the first and the last direction
    bool is_on_border = false;   ///< nothing lies between the last and the first direction
  };

  /// A straight piece between two nodes.
  struct Arc
  {
    int source = -1, target = -1; ///< nodes
    double length = 0;            ///< in the map, in quad edges; positive
    double rounded_length = 0; ///< an integer: the length after the integers of the map were rounded, may be negative
    bool is_aligned = false;   ///< a part of a feature, or of the border
    std::array<int, 2> patch{ { -1, -1 } }; ///< on its left and on its right; -1: nothing
    int line = -1;                          ///< the straight line that it is a part of
    double begin = 0;                       ///< where it begins on the line
  };

  /// A rectangle.
  struct Patch
  {
    std::array<std::vector<int>, 4> sides; ///< directions, counterclockwise around the patch, that is, on their left
  };

  std::vector<Node> nodes;
  std::vector<Arc> arcs;
  std::vector<Patch> patches;

  /// Why there is no T-mesh: a sentence; empty if there is one.
  std::string message = "There is no T-mesh.";

  /// returns whether there is a T-mesh.
  bool is_valid() const { return message.empty(); }

  /// returns the node where a direction begins.
  int source(int direction) const { return direction & 1 ? arcs[direction / 2].target : arcs[direction / 2].source; }

  /// returns the node where a direction ends.
  int target(int direction) const { return source(direction ^ 1); }

  /// returns the length of a side of a patch in the map, in quad edges.
  double length(int patch, int side) const
  {
    double sum = 0;
    for(int d : patches[patch].sides[side])
      sum += arcs[d / 2].length;
    return sum;
  }

  /// returns the place on an arc at a distance from its source, in the map.
  Location locate(int arc, double distance) const;

  /*!
  returns the place of a point of a patch.

  \param patch the patch
  \param u the distance from the beginning of side 0, along this side
  \param v the distance from side 0
  */
  Location locate_in_patch(int patch, double u, double v) const;

  /// returns the polyline of an arc on the triangle mesh: where it begins, crosses edges, and ends.
  std::vector<Location> polyline(int arc) const;

  /// returns the image of a corner of a face, 0 to 2, under the seamless map, in the chart of the face.
  std::array<double, 2> image(std::size_t face, int corner) const { return m_charts->corner[3 * face + corner]; }

  /// returns the coordinates of a place.
  std::array<double, 3> position(const Location& l) const
  {
    std::array<double, 3> p{ { 0, 0, 0 } };
    for(int k = 0; k < 3; ++k)
      for(int i = 0; i < 3; ++i)
        p[i] += l.second[k] * m_charts->mesh.points[m_charts->mesh.corners[l.first][k]][i];
    return p;
  }

private:
  friend class internal::T_mesh_builder;

  // A part of a line in a face, or along an edge of it; then the face lies on the left.
  struct Piece
  {
    int face;
    int edge;
    int heading;
    internal::Chart_point origin; // the start of the line, seen from the chart of the face
    double begin, end;
  };

  struct Line
  {
    std::vector<Piece> pieces;
    double length = 0;
    bool is_closed = false;
  };

  // The piece at a distance from the start of its line.
  const Piece& piece_at(const Line& line, double& at) const
  {
    if(line.is_closed && at >= line.length)
      at -= line.length;
    auto p = std::upper_bound(line.pieces.begin(), line.pieces.end(), at,
                              [](double x, const Piece& piece) { return x < piece.begin; });
    return p == line.pieces.begin() ? *p : *(p - 1);
  }

  Location place(int face, const internal::Chart_point& p) const
  {
    return Location(static_cast<std::size_t>(face), m_charts->weights(face, p));
  }

  std::shared_ptr<const internal::Seamless_charts> m_charts;
  std::vector<Line> m_lines;
};

inline T_mesh::Location T_mesh::locate(int arc, double distance) const
{
  const Arc& a = arcs[arc];
  double at = a.begin + distance;
  const Piece& p = piece_at(m_lines[a.line], at);
  return place(p.face, internal::moved(p.origin, p.heading, at));
}

inline std::vector<T_mesh::Location> T_mesh::polyline(int arc) const
{
  const Arc& a = arcs[arc];
  const Line& line = m_lines[a.line];
  std::vector<Location> result(1, locate(arc, 0));
  for(double shift : { 0., line.is_closed ? line.length : 0. })
  {
    for(const Piece& p : line.pieces)
      if(p.begin + shift > a.begin && p.begin + shift < a.begin + a.length)
        result.push_back(place(p.face, internal::moved(p.origin, p.heading, p.begin)));
    if(!line.is_closed)
      break;
  }
  result.push_back(locate(arc, a.length));
  return result;
}

inline T_mesh::Location T_mesh::locate_in_patch(int patch, double u, double v) const
{
  typedef internal::Chart_point Chart_point;
  const std::vector<int>& side = patches[patch].sides[0];
  std::size_t i = 0;
  while(i + 1 < side.size() && u > arcs[side[i] / 2].length)
    u -= arcs[side[i++] / 2].length;
  const Arc& a = arcs[side[i] / 2];
  const bool is_backward = side[i] & 1;
  double at = a.begin + (is_backward ? a.length - u : u);
  const Piece& piece = piece_at(m_lines[a.line], at);

  int face = piece.face, heading = (piece.heading + (is_backward ? 3 : 1)) & 3;
  Chart_point from = internal::moved(piece.origin, piece.heading, at);
  if(is_backward && piece.edge != -1) // the patch lies beyond the edge
  {
    from = m_charts->across(piece.edge, from);
    heading = m_charts->heading_across(piece.edge, heading);
    face = m_charts->mesh.opposite[piece.edge] / 3;
  }
  Chart_point to = internal::moved(from, heading, v);
  // Straight on from triangle to triangle.
  const double tolerance = 1e-12; // of the area of a triangle, in doubles
  int entry = -1;
  for(int step = 0; step < m_charts->mesh.number_of_faces(); ++step)
  {
    const Chart_point* c = &m_charts->corner[3 * face];
    const double area = internal::Seamless_charts::double_area(c[0], c[1], c[2]);
    int exit = -1, worst = -1;
    double least = -tolerance * area;
    for(int k = 0; k < 3; ++k)
    {
      const int h = 3 * face + k;
      const double side_of = internal::Seamless_charts::double_area(c[k], c[(k + 1) % 3], to);
      if(!(side_of < -tolerance * area) || h == entry)
        continue;
      if(side_of < least)
      {
        least = side_of;
        worst = h;
      }
      if(internal::Seamless_charts::double_area(from, to, c[k]) <= 0 &&
         internal::Seamless_charts::double_area(from, to, c[(k + 1) % 3]) >= 0)
        exit = h;
    }
    if(exit == -1)
      exit = worst;
    if(exit == -1 || m_charts->mesh.opposite[exit] == -1)
      break;
    from = m_charts->across(exit, from);
    to = m_charts->across(exit, to);
    entry = m_charts->mesh.opposite[exit];
    face = entry / 3;
  }
  return place(face, to);
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_T_MESH_H
