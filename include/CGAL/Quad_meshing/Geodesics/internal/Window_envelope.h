// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_ENVELOPE_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_ENVELOPE_H

#include <CGAL/Quad_meshing/Geodesics/internal/Window.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Inserts windows into the lower envelope of the windows of one edge: a list, sorted along the
// edge, of windows that do not overlap. Windows from both sides share the list: a point of the edge
// that is reached sooner from the other side is no place to go on from.
//
// One object serves all edges; it keeps its buffers from one insertion to the next.
template <typename FT>
class Window_envelope
{
public:
  typedef Window<FT> W;
  typedef std::vector<W> List;

  // Inserts the part of `w`, whose key is set, that is nearest. Returns whether any part of it is; those parts then
  // are pending in the list, and `key` is the smallest of their keys.
  bool insert(List& list, W& w, const FT& length, float& key)
  {
    const FT place = FT(Tol::place()) * length;
    std::size_t i = 0;
    if(! list.empty() && list.back().b1 <= w.b0)
      i = list.size();
    while(i < list.size() && list[i].b1 <= w.b0)
      ++i;
    std::size_t j = i;
    while(j < list.size() && list[j].b0 < w.b1)
      ++j;
    adjust_ends(list, w, i, j, length);
    while(i < j && list[i].b1 <= w.b0)
      ++i;
    while(j > i && list[j - 1].b0 >= w.b1)
      --j;
    if(! (w.b1 - w.b0 > place))
      return false;

    if(i == j)
    {
      fill_gap(list, i, w);
      key = w.key;
      return true;
    }

    // list[i..j[ overlap with w. Sweep over them.
    m_pieces.clear();
    m_has_new = false;
    FT from = w.b0;
    for(std::size_t k = i; k < j; ++k)
    {
      const W& old = list[k];
      const FT l = (std::max)(from, old.b0), r = (std::min)(w.b1, old.b1);
      if(old.b0 < l)
        add_old(old, old.b0, l);
      else if(l - from > place)
        add_new(w, from, l);
      share(w, old, l, r, place);
      if(r < old.b1)
        add_old(old, r, old.b1);
      from = r;
    }
    if(w.b1 - from > place)
      add_new(w, from, w.b1);
    if(! m_has_new)
      return false;

    return replace(list, i, j, key);
  }

private:
  typedef Window_tolerances<FT> Tol;

  // A piece of the new list: of the new window, or of the old one whose end it follows.
  struct Piece
  {
    W window;
    bool is_new;
  };

  // Inserts w, which overlaps with nothing, before list[i]: by far the most frequent case.
  void fill_gap(List& list, std::size_t i, W& w) const
  {
    const bool joins_left = i > 0 && can_join(list[i - 1], w);
    const bool joins_right = i < list.size() && can_join(w, list[i]);
    if(joins_left)
    {
      w.b0 = list[i - 1].b0;
      w.key = (std::min)(w.key, list[i - 1].key);
    }
    if(joins_right)
    {
      w.b1 = list[i].b1;
      w.key = (std::min)(w.key, list[i].key);
    }
    if(joins_left && joins_right)
    {
      list[i - 1] = w;
      list.erase(list.begin() + i);
    }
    else if(joins_left || joins_right)
      list[joins_left ? i - 1 : i] = w;
    else
    {
      if(list.size() == list.capacity())
        list.reserve(list.empty() ? first_capacity() : list.size() + list.size() / 2);
      list.insert(list.begin() + i, w);
    }
  }

  static std::size_t first_capacity() { return 4; }

  // Moves the ends of w to places where something ends already, when they are that close.
  void adjust_ends(const List& list, W& w, std::size_t i, std::size_t j, const FT& length) const
  {
    const FT place = FT(Tol::place()) * length;

    if(i < list.size() && list[i].b0 < w.b0)
    {
      if(w.b0 - list[i].b0 <= place)
        w.b0 = list[i].b0;
      else if(list[i].b1 - w.b0 <= place)
        w.b0 = list[i].b1;
    }
    else
    {
      const FT left = i > 0 ? list[i - 1].b1 : FT(0);
      if(w.closes_gap(w.b0 - left, w.b0, length))
        w.b0 = left;
    }

    if(j > 0 && list[j - 1].b1 > w.b1 && list[j - 1].b0 < w.b1)
    {
      if(list[j - 1].b1 - w.b1 <= place)
        w.b1 = list[j - 1].b1;
      else if(w.b1 - list[j - 1].b0 <= place)
        w.b1 = list[j - 1].b0;
    }
    else
    {
      const FT right = j < list.size() ? list[j].b0 : length;
      if(w.closes_gap(right - w.b1, w.b1, length))
        w.b1 = right;
    }
  }

  void add_old(const W& old, const FT& b0, const FT& b1) { add(old, b0, b1, false); }
  void add_new(const W& w, const FT& b0, const FT& b1) { add(w, b0, b1, true); m_has_new = true; }

  void add(const W& w, const FT& b0, const FT& b1, bool is_new)
  {
    if(! m_pieces.empty() && m_pieces.back().is_new == is_new && m_pieces.back().window.b1 == b0 &&
       (is_new || m_last_old == &w))
      m_pieces.back().window.b1 = b1;
    else
    {
      m_pieces.push_back(Piece{ w, is_new });
      m_pieces.back().window.b0 = b0;
      m_pieces.back().window.b1 = b1;
    }
    if(! is_new)
      m_last_old = &w;
  }

  // -1 if the new window is nearer at t, 1 if the old one is, 0 if they tie.
  static int compare(const W& w, const W& old, const FT& t)
  {
    const FT d = old.distance(t), difference = w.distance(t) - d;
    const FT tie = FT(Tol::tie()) * absolute(d);
    return difference < -tie ? -1 : difference > tie ? 1 : 0;
  }

  // Divides [l, r] among the two windows.
  void share(const W& w, const W& old, const FT& l, const FT& r, const FT& place)
  {
    if(! (l < r))
      return;
    const int at_l = compare(w, old, l), at_r = compare(w, old, r);
    FT z[2];
    int n = equal_distance_places(w, old, l, FT(r - l), z);
    if(n == 0 && at_l * at_r == -1)
    {
      z[0] = (r - l) / FT(2);
      n = 1;
    }
    // The ends of the pieces, without those that would be too narrow.
    FT cut[4] = { l, l, l, l };
    int m = 1;
    for(int k = 0; k < n; ++k)
    {
      const FT t = polished(w, old, FT(l + z[k]), l, r);
      if(t - cut[m - 1] > place && r - t > place)
        cut[m++] = t;
    }
    cut[m++] = r;
    for(int k = 0; k + 1 < m; ++k)
    {
      int nearer;
      if(m == 2 && at_l * at_r == 1)
        nearer = at_l;
      else
        nearer = compare(w, old, FT((cut[k] + cut[k + 1]) / FT(2)));
      if(nearer == -1)
        add_new(w, cut[k], cut[k + 1]);
      else
        add_old(old, cut[k], cut[k + 1]);
    }
  }

  // The quadratic equation loses digits that one Newton step on the distances themselves gives back.
  static FT polished(const W& w, const W& old, const FT& t, const FT& l, const FT& r)
  {
    const FT slope = derivative(w, t) - derivative(old, t);
    const FT s = t - (w.distance(t) - old.distance(t)) / slope;
    return s > l && s < r ? s : t;
  }

  static FT derivative(const W& w, const FT& t)
  {
    if(w.linear)
      return w.x;
    const FT d = t - w.x;
    return d / square_root(d * d + w.y * w.y);
  }

  // Puts the pieces in the place of list[i..j[, joins windows with one source, and sets keys.
  bool replace(List& list, std::size_t i, std::size_t j, float& key)
  {
    // neighbours may join with the new pieces
    if(i > 0 && m_pieces.front().is_new && can_join(list[i - 1], m_pieces.front().window))
    {
      m_pieces.front().window.b0 = list[i - 1].b0;
      --i;
    }
    if(j < list.size() && m_pieces.back().is_new && can_join(m_pieces.back().window, list[j]))
    {
      m_pieces.back().window.b1 = list[j].b1;
      ++j;
    }
    std::size_t n = 0;
    for(std::size_t k = 0; k < m_pieces.size(); ++k)
    {
      const Piece& p = m_pieces[k];
      if(n > 0 && (p.is_new || m_pieces[n - 1].is_new) && can_join(m_pieces[n - 1].window, p.window))
      {
        m_pieces[n - 1].window.b1 = p.window.b1;
        m_pieces[n - 1].is_new = true;
      }
      else
        m_pieces[n++] = p;
    }
    m_pieces.resize(n);

    bool first = true;
    for(Piece& p : m_pieces)
    {
      if(p.window.pending)
        p.window.set_key();
      if(p.is_new && (first || p.window.key < key))
      {
        key = p.window.key;
        first = false;
      }
    }

    const std::size_t old_size = j - i;
    const std::size_t common = (std::min)(n, old_size);
    for(std::size_t k = 0; k < common; ++k)
      list[i + k] = m_pieces[k].window;
    if(n < old_size)
      list.erase(list.begin() + (i + n), list.begin() + j);
    else if(n > old_size)
    {
      const std::size_t tail = list.size() - j;
      list.resize(list.size() + (n - old_size));
      std::move_backward(list.begin() + j, list.begin() + (j + tail), list.end());
      for(std::size_t k = common; k < n; ++k)
        list[i + k] = m_pieces[k].window;
    }
    return true;
  }

  static bool can_join(const W& a, const W& b)
  {
    return a.b1 == b.b0 && a.pending && b.pending && have_same_source(a, b);
  }

  std::vector<Piece> m_pieces;
  const W* m_last_old = nullptr;
  bool m_has_new = false;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_ENVELOPE_H
