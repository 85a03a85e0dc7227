// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_DEFAULT_VISITOR_H
#define CGAL_QUAD_MESHING_DEFAULT_VISITOR_H

#include <string>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingRef
 *
 * \brief is the visitor that the functions of this package use when the user passes none: it looks
 * at nothing and lets every algorithm run to its end.
 *
 * A visitor is passed by reference through the named parameter `visitor`, as
 * `parameters::visitor(std::ref(my_visitor))`. It learns which stage begins and ends and how far
 * the current stage has come, and it may ask for an early end. Stages may be nested; they end in
 * the opposite order of their beginnings, also when an algorithm stops early.
 *
 * Derive from this class and hide the functions that matter: all calls are resolved at compile time.
 */
struct Default_visitor
{
  /// is called when the stage called `name` begins.
  void on_stage_begin(const std::string& /* name */) {}

  /// is called when the stage called `name` ends.
  void on_stage_end(const std::string& /* name */) {}

  /// is called with the completed part of the innermost running stage, a number from 0 to 1 that
  /// never decreases within a stage.
  void progress(double /* completed */) {}

  /// returns `false` if the algorithm should stop as soon as it can. A stopped algorithm leaves the
  /// meshes as they were, and its result says that it was stopped.
  bool go_further() { return true; }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_DEFAULT_VISITOR_H
