// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_NAMED_VISITOR_H
#define CGAL_QUAD_MESHING_INTERNAL_NAMED_VISITOR_H

#include <CGAL/Quad_meshing/Default_visitor.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <string>
#include <type_traits>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The visitor that a pack of named parameters names, or one that does nothing, as an `Any_visitor`. The visitor of the
// user must outlive it.
template <typename NamedParameters>
class Named_visitor : public Any_visitor
{
  typedef
    typename internal_np::Lookup_named_param_def<internal_np::visitor_t, NamedParameters, Default_visitor>::reference
      Visitor_reference;

public:
  explicit Named_visitor(const NamedParameters& np)
    : m_adaptor(
        parameters::choose_parameter(parameters::get_parameter_reference(np, internal_np::visitor), m_default_visitor))
  {
  }

  void on_stage_begin(const std::string& name) override { m_adaptor.on_stage_begin(name); }
  void on_stage_end(const std::string& name) override { m_adaptor.on_stage_end(name); }
  void progress(double completed) override { m_adaptor.progress(completed); }
  bool go_further() override { return m_adaptor.go_further(); }

private:
  Default_visitor m_default_visitor;
  Visitor_adaptor<std::remove_reference_t<Visitor_reference>> m_adaptor;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_NAMED_VISITOR_H
