// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_LAYOUT_WEIGHTS_H
#define CGAL_QUAD_MESHING_LAYOUT_LAYOUT_WEIGHTS_H

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What decides between layouts: the weights of the distortion, the goals, and the prices of what is missed.
//
// The goals are a choice: what somebody who asks for a coarser structure will hardly mind. All other numbers were tuned
// by the results on quad meshes of botijo, fertility, rockerarm and the fan disk with about 4000 quads, unless
// something else is said. Prices are numbers without unit: they are only added and compared.
struct Layout_weights
{
  // Distortion: each weight is that of a squared strain, a number without unit, against that of shear, which is 1.
  // Shear makes corners crooked; the others do not, but the smoothing turns part of them into shear.
  static constexpr double stretch = 0.25; // unequal lengths of the sides of a quad
  static constexpr double size = 0.05;    // both sides longer or shorter
  static constexpr double rotation = 0.1; // a quad that is turned
  // The growth of the squared mean deviation from right angles, in squared degrees, for a distortion of one. Measured:
  // a distortion of 0.01 is followed by about two squared degrees after the smoothing.
  static constexpr double squared_degrees = 200;

  // Goals, each a part of what the input has.
  static constexpr double helices = 0.2;  // that may be left, of their number
  static constexpr double patches = 0.33; // that may be left, of their number
  static constexpr double loss = 0.3;     // of quads
  static constexpr double growth = 1.35;  // of the mean deviation of the corners from right angles
  // So many helices may be left in any case, and no more patches for each irregular vertex. Measured at 4000 quads:
  // fandisk, whose 1682 patches have two helices, comes to 431 patches if one may be left, to 286 if four may.
  // By a third of their number alone, 238 patches are left of rockerarm (34 irregular vertices) and 464 of fertility
  // (44); by the irregular vertices 158 and 214, and corners deviate by 0.8 and 1.2 degrees more.
  static constexpr int few_helices = 4;
  // So many helices where only the layout is wanted, and quads are made anew along it. Measured on a fandisk of 4026
  // quads, 1440 patches and three helices: 357 patches are left if four may be, 248 if twelve may, 181 if thirty or
  // forty may.
  static constexpr int few_helices_where_a_layout_is_wanted = 40;
  static constexpr double patches_per_irregular_vertex = 5;
  // Numbers below which the input counts as if it had these: nobody minds five helices that cross themselves, nor sees
  // whether corners deviate by two degrees or by three.
  static constexpr int least_crossings = 5;
  static constexpr double least_deviation = 5; // degrees
  // The part of the quads of the input below which a target for their number is no goal: the user wants the layout.
  static constexpr double least_target = 0.25;

  // The price of what is left of a thing, in units of its goal: this, ...
  static constexpr double below_goal = 0.5;
  // ... and for what exceeds the goal this more. Helices and patches come first, as they are what was asked for.
  static constexpr double helices_and_patches_above_goal = 6;
  static constexpr double loss_above_goal = 6;
  static constexpr double loss_above_goal_when_neglected = 2; // once no layout with all the quads has reached the goals
  static constexpr double growth_above_goal = 3;
  // The price of as many quads too many as were asked for. High enough to exclude them: quads can be left out by the
  // number of parallel curves.
  static constexpr double surplus = 30;

  // What is no goal: as many helices that cross themselves as the input has, and features from whose chords they are,
  // in the mean, one tolerated distance too far away (`Layout_curves::feature_distance`).
  static constexpr double crossings = 0.5;
  static constexpr double features = 5;

  // The factor of the distortion each time a shape was not accepted.
  static constexpr double caution = 2;

  // The search for a path along which lengths are changed: the least price of an arc on it, in units of the mean price
  // of an arc, so that every arc costs something, and the largest price of a crossing of one edge, which is drawn at
  // random to find different paths.
  static constexpr double least_arc = 0.05;
  static constexpr double largest_edge = 0.1;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_LAYOUT_WEIGHTS_H
