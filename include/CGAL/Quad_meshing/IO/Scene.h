// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_SCENE_H
#define CGAL_QUAD_MESHING_IO_SCENE_H

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/// \ingroup PkgQuadMeshingIORef
/// \brief What the elements of a layer are.
enum class Scene_layer_kind
{
  FACES, ///< polygons of three or more corners
  LINES, ///< polylines of two or more points
  POINTS ///< single points
};

/// \ingroup PkgQuadMeshingIORef
/// \brief Where a layer is drawn when two pictures stand side by side.
enum class Scene_side
{
  BOTH, ///< in both pictures
  LEFT, ///< in the left one, for what comes first
  RIGHT ///< in the right one, for what is made of it
};

/// \ingroup PkgQuadMeshingIORef
/// \brief How numbers become colors.
enum class Scene_color_scale
{
  SEQUENCE,   ///< from dark at `low` to light at `high`, which may be the smaller one
  CATEGORIES, ///< a color for each whole number; neighbors in the order of numbers have colors that differ
  SIGNED      ///< red for positive numbers, blue for negative ones, gray for zero
};

/*!
\ingroup PkgQuadMeshingIORef

\brief One number for each element of a layer.
*/
struct Scene_numbers
{
  std::string name;                                      ///< as `scaled Jacobian`
  std::string unit;                                      ///< as `degrees`; may be empty
  std::vector<double> values;                            ///< as many as there are elements; shown in single precision
  Scene_color_scale scale = Scene_color_scale::SEQUENCE; ///< for elements that are colored by these numbers
  /// \name Ends of a Sequence of Colors
  /// Not a number: that of the values.
  /// @{
  double low = std::numeric_limits<double>::quiet_NaN();  ///< where the colors begin
  double high = std::numeric_limits<double>::quiet_NaN(); ///< where they end
  /// @}
};

/*!
\ingroup PkgQuadMeshingIORef

\brief A part of an `Scene` that has a switch: faces, lines or points, with numbers for each of them.
*/
struct Scene_layer
{
  std::string name;                                ///< of its switch
  std::string group;                               ///< the heading above its switch
  Scene_layer_kind kind = Scene_layer_kind::FACES; ///< what its elements are
  Scene_side side = Scene_side::BOTH;              ///< where it is drawn
  bool is_visible = true;                          ///< at the beginning
  bool has_sides = true;                           ///< whether the sides of faces are drawn as lines
  std::string color = "#b8c4d0";                   ///< of elements that no number colors, as in CSS

  std::vector<std::array<double, 3>> points;     ///< in the unit of the model
  std::vector<std::size_t> corners;              ///< numbers of `points`, element after element
  std::vector<std::size_t> first_corner = { 0 }; ///< of each element, and at the end the size of `corners`
  /// Coordinates of an integer grid, one pair for each of `corners`, which is drawn on the faces; or empty.
  std::vector<std::array<double, 2>> grid;
  std::vector<Scene_numbers> numbers; ///< shown for the element that is picked
  int colored_by = -1;                ///< which of `numbers` colors the elements; -1: none

  /// returns the number of elements.
  std::size_t size() const { return first_corner.size() - 1; }

  /// adds an element with the given numbers of points.
  template <typename PointNumbers>
  void add_element(const PointNumbers& point_numbers)
  {
    corners.insert(corners.end(), point_numbers.begin(), point_numbers.end());
    first_corner.push_back(corners.size());
  }

  /// adds a point. \return its number
  std::size_t add_point(const std::array<double, 3>& p)
  {
    points.push_back(p);
    return points.size() - 1;
  }
};

/*!
\ingroup PkgQuadMeshingIORef

\brief Counts of numbers that lie in intervals of one length.
*/
struct Scene_histogram
{
  std::string name;                ///< its heading
  std::string unit;                ///< may be empty
  double low = 0;                  ///< where the first interval begins
  double high = 1;                 ///< where the last one ends
  std::vector<std::size_t> counts; ///< one for each interval
};

/*!
\ingroup PkgQuadMeshingIORef

\brief What a page of `write_html_page()` shows.
*/
struct Scene
{
  typedef std::vector<std::pair<std::string, std::string>> Table; ///< names and values

  std::string title;   ///< of the page
  std::string message; ///< below the title
  std::vector<Scene_layer> layers;
  std::vector<Scene_histogram> histograms;
  Table figures;                    ///< what was measured
  Table options;                    ///< what was asked for
  std::vector<std::string> remarks; ///< sentences about the page itself, as what it leaves away
  bool is_side_by_side = false;     ///< whether there are two pictures at the beginning
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_SCENE_H
