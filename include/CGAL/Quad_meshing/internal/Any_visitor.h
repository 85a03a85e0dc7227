// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_ANY_VISITOR_H
#define CGAL_QUAD_MESHING_INTERNAL_ANY_VISITOR_H

#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A visitor of any type behind one interface, so that compiled kernels can talk to it. It lets everything pass, as
// `Default_visitor` does, unless a derived class says otherwise.
class Any_visitor
{
public:
  Any_visitor() = default;
  Any_visitor(const Any_visitor&) = delete;
  Any_visitor& operator=(const Any_visitor&) = delete;
  virtual ~Any_visitor() = default;

  virtual void on_stage_begin(const std::string& /* name */) {}
  virtual void on_stage_end(const std::string& /* name */) {}
  virtual void progress(double /* completed */) {}
  virtual bool go_further() { return true; }
};

template <typename Visitor, typename = void>
struct Is_visitor : std::false_type
{
};

template <typename Visitor>
struct Is_visitor<Visitor, std::void_t<decltype(std::declval<Visitor&>().on_stage_begin(std::string())),
                                       decltype(std::declval<Visitor&>().on_stage_end(std::string())),
                                       decltype(std::declval<Visitor&>().progress(0.5)),
                                       decltype(static_cast<bool>(std::declval<Visitor&>().go_further()))>>
  : std::true_type
{
};

// The visitor of a user as an `Any_visitor`. It must outlive this object.
template <typename Visitor>
class Visitor_adaptor : public Any_visitor
{
  static_assert(Is_visitor<Visitor>::value,
                "The visitor lacks on_stage_begin(name), on_stage_end(name), progress(completed) or go_further(): "
                "derive it from CGAL::Quad_meshing::Default_visitor and pass it by std::ref().");

public:
  explicit Visitor_adaptor(Visitor& visitor) : m_visitor(visitor) {}

  void on_stage_begin(const std::string& name) override { m_visitor.on_stage_begin(name); }
  void on_stage_end(const std::string& name) override { m_visitor.on_stage_end(name); }
  void progress(double completed) override { m_visitor.progress(completed); }
  bool go_further() override { return m_visitor.go_further(); }

private:
  Visitor& m_visitor;
};

// A stage of a visitor that ends where the scope ends, however it is left.
class Visited_stage
{
public:
  Visited_stage(Any_visitor& visitor, std::string name) : m_visitor(visitor), m_name(std::move(name))
  {
    m_visitor.on_stage_begin(m_name);
  }

  Visited_stage(const Visited_stage&) = delete;
  Visited_stage& operator=(const Visited_stage&) = delete;
  ~Visited_stage() { m_visitor.on_stage_end(m_name); }

private:
  Any_visitor& m_visitor;
  const std::string m_name;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_ANY_VISITOR_H
