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
#include <CGAL/Quad_meshing/Geodesics/internal/Window_lists.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_predicates.h>

#include <boost/config.hpp>

#include <algorithm>
#include <limits>
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
  typedef Window_lists<FT> Lists;
  typedef Window_list<FT> List;

  enum Insertion
  {
    NOTHING, // w is nowhere nearer
    ALL,     // all of w is in the list, its ends perhaps moved a little
    PARTS    // `nearest_part()` is the smallest distance of the parts that are
  };

  // Inserts the part of `w` that is nearest. Windows that come in their order along the edge, or against it, are
  // found a place sooner if `hint` is kept from one to the next.
  BOOST_FORCEINLINE Insertion insert(Lists& lists, List& list, int& hint, W& w, const FT& length)
  {
    const FT place = FT(Tol::place()) * length;
    int i = (std::min)(hint, list.size);
    while(i > 0 && list[i - 1].b1 > w.b0)
      --i;
    while(i < list.size && list[i].b1 <= w.b0)
      ++i;
    int j = i;
    while(j < list.size && list[j].b0 < w.b1)
      ++j;

    // Move the ends of w to places where something ends already, when they are that close.
    if(i < j && list[i].b0 < w.b0)
    {
      if(!Predicates::is_wider(list[i].b0, w.b0, place))
        w.b0 = list[i].b0;
      else if(!Predicates::is_wider(w.b0, list[i].b1, place))
        w.b0 = list[i++].b1;
    }
    else
    {
      const FT left = i > 0 ? list[i - 1].b1 : FT(0);
      if(Predicates::is_closed_gap(w, left, w.b0, w.b0, length))
        w.b0 = left;
    }
    if(i < j && list[j - 1].b1 > w.b1)
    {
      if(!Predicates::is_wider(w.b1, list[j - 1].b1, place))
        w.b1 = list[j - 1].b1;
      else if(!Predicates::is_wider(list[j - 1].b0, w.b1, place))
        w.b1 = list[--j].b0;
    }
    else
    {
      const FT right = j < list.size ? list[j].b0 : length;
      if(Predicates::is_closed_gap(w, w.b1, right, w.b1, length))
        w.b1 = right;
    }
    if(!Predicates::is_wider(w.b0, w.b1, place))
      return NOTHING;

    hint = i;
    if(i < j)
    {
      if(j - i > 1 || !meet(list[i], w, place))
        return insert_overlapping(lists, list, hint, j, w, length);
      if(list[i].b1 <= w.b0)
        ++hint;
    }
    fill_gap(lists, list, hint, w);
    return ALL;
  }

  const FT& nearest_part() const { return m_nearest; }

private:
  typedef Window_tolerances<FT> Tol;
  typedef Window_predicates<FT> Predicates;

  // A piece of the new list: of the new window, or of one of the old ones.
  struct Piece
  {
    int old;     // its number among the old ones, -1 for the new one
    bool is_new; // contains a part of the new one
    FT b0, b1;
  };

  // Inserts w, which overlaps with nothing, before list[i]: by far the most frequent case.
  BOOST_FORCEINLINE void fill_gap(Lists& lists, List& list, int& i, W& w) const
  {
    const bool joins_left = i > 0 && can_join(list[i - 1], list[i - 1].b1, w, w.b0);
    const bool joins_right = i < list.size && can_join(w, w.b1, list[i], list[i].b0);
    if(!joins_left && !joins_right)
    {
      lists.insert(list, i) = w;
      return;
    }
    if(joins_left)
      w.b0 = list[--i].b0;
    if(joins_right)
      w.b1 = list[i + joins_left].b1;
    *lists.splice(list, i, joins_left + joins_right, 1) = w;
  }

  // The simple case of two windows that overlap at one end of each, where a ridge of the distance runs between them:
  // each keeps what is on its side. Returns false if it is not that simple.
  static bool meet(W& old, W& w, const FT& place)
  {
    const bool old_is_first = old.b0 < w.b0 && old.b1 < w.b1;
    if(!old_is_first && !(w.b0 < old.b0 && w.b1 < old.b1))
      return false;
    W &first = old_is_first ? old : w, &second = old_is_first ? w : old;
    const FT l = second.b0, r = first.b1;
    FT z[2];
    if(Predicates::compare_distances(first, first.distance(l), second, second.distance(l), l) != -1 ||
       Predicates::compare_distances(first, first.distance(r), second, second.distance(r), r) != 1 ||
       equal_distance_places(first, second, l, FT(r - l), z) != 1)
      return false;
    const FT t = polished(first, second, FT(l + z[0]), l, r);
    if(!Predicates::is_wider(l, t, place) || !Predicates::is_wider(t, r, place))
      return false;
    first.b1 = t;
    second.b0 = t;
    return true;
  }

  // Inserts w, which overlaps with the windows i to j-1.
  BOOST_NOINLINE Insertion insert_overlapping(Lists& lists, List& list, int& i, int j, W w, const FT& length)
  {
    const FT place = FT(Tol::place()) * length;
    m_pieces.clear();
    m_old.assign(list.begin() + i, list.begin() + j);
    bool is_nearer = false;
    FT from = w.b0;
    for(int k = 0; k < j - i; ++k)
    {
      const W& old = m_old[k];
      const FT l = (std::max)(from, old.b0), r = (std::min)(w.b1, old.b1);
      if(old.b0 < l)
        add(k, old.b0, l);
      else if(Predicates::is_wider(from, l, place))
      {
        add(-1, from, l);
        is_nearer = true;
      }
      is_nearer = share(w, k, l, r, place) || is_nearer;
      if(r < old.b1)
        add(k, r, old.b1);
      from = r;
    }
    if(Predicates::is_wider(from, w.b1, place))
    {
      add(-1, from, w.b1);
      is_nearer = true;
    }
    if(!is_nearer)
      return NOTHING;

    // neighbours may join with the new pieces
    Piece &front = m_pieces.front(), &back = m_pieces.back();
    if(i > 0 && front.is_new && can_join(list[i - 1], list[i - 1].b1, w, front.b0))
      front.b0 = list[--i].b0;
    if(j < list.size && back.is_new && can_join(w, back.b1, list[j], list[j].b0))
      back.b1 = list[j++].b1;
    std::size_t n = 0;
    for(const Piece& p : m_pieces)
    {
      if(n > 0 && (p.is_new || m_pieces[n - 1].is_new) &&
         can_join(window(m_pieces[n - 1], w), m_pieces[n - 1].b1, window(p, w), p.b0))
      {
        m_pieces[n - 1].b1 = p.b1;
        m_pieces[n - 1].is_new = true;
      }
      else
        m_pieces[n++] = p;
    }

    W* place_in_list = lists.splice(list, i, j - i, static_cast<int>(n));
    bool is_first = true;
    for(std::size_t k = 0; k < n; ++k)
    {
      const Piece& p = m_pieces[k];
      W& v = *place_in_list++;
      v = window(p, w);
      v.b0 = p.b0;
      v.b1 = p.b1;
      if(p.is_new)
      {
        const FT d = v.minimum();
        if(is_first || d < m_nearest)
          m_nearest = d;
        is_first = false;
      }
    }
    return PARTS;
  }

  const W& window(const Piece& p, const W& w) const { return p.old == -1 ? w : m_old[p.old]; }

  void add(int old, const FT& b0, const FT& b1)
  {
    if(!m_pieces.empty() && m_pieces.back().old == old && m_pieces.back().b1 == b0)
      m_pieces.back().b1 = b1;
    else
      m_pieces.push_back(Piece{ old, old == -1, b0, b1 });
  }

  // Divides [l, r] among the new window and an old one. Returns whether any part is for the new one.
  //
  // The places where they are equally far are found in the number type, with its rounding. Which of them is nearer
  // between these places is decided by predicates, and the old one stays where they tie.
  bool share(const W& w, int k, const FT& l, const FT& r, const FT& place)
  {
    if(!(l < r))
      return false;
    const W& old = m_old[k];
    const FT width = r - l;
    const FT w_l = w.distance(l), w_r = w.distance(r), old_l = old.distance(l), old_r = old.distance(r);
    const int at_l = Predicates::compare_distances(w, w_l, old, old_l, l),
              at_r = Predicates::compare_distances(w, w_r, old, old_r, r);
    // The ends of the pieces, without those that would be too narrow.
    FT cut[4] = { l, r, r, r };
    int m = 1, n = 0;
    // the difference cannot change faster than 2, so else it changes its sign nowhere but in a tie
    if(at_l * at_r != 1 || absolute(w_l - old_l) + absolute(w_r - old_r) < FT(2) * width)
    {
      FT z[2];
      n = equal_distance_places(w, old, l, width, z);
      if(n == 0 && at_l * at_r == -1)
      {
        z[0] = change_of_sign(w, old, l, r, at_l) - l;
        n = 1;
      }
      for(int c = 0; c < n; ++c)
      {
        const FT t = polished(w, old, FT(l + z[c]), l, r);
        if(Predicates::is_wider(cut[m - 1], t, place) && Predicates::is_wider(t, r, place))
          cut[m++] = t;
      }
      cut[m] = r;
    }
    // what is nearer at the ends tells about the pieces
    const bool is_clear = (m == 1 && at_l * at_r == 1) || (m == 2 && n == 1 && at_l * at_r == -1);
    bool any = false;
    for(int c = 0; c < m; ++c)
    {
      const FT t = (cut[c] + cut[c + 1]) / FT(2);
      const int nearer = !is_clear ? Predicates::compare_distances(w, w.distance(t), old, old.distance(t), t)
                         : c == 0  ? at_l
                                   : at_r;
      add(nearer == -1 ? -1 : k, cut[c], cut[c + 1]);
      any = any || nearer == -1;
    }
    return any;
  }

  // A place between l and r at which the difference of the distances changes its sign, which is `at_l` at l.
  static FT change_of_sign(const W& w, const W& old, FT l, FT r, int at_l)
  {
    for(int i = 0; i < std::numeric_limits<FT>::digits; ++i)
    {
      const FT t = (l + r) / FT(2);
      ((w.distance(t) < old.distance(t)) == (at_l < 0) ? l : r) = t;
    }
    return l;
  }

  // The quadratic equation loses digits that one Newton step on the distances themselves gives back.
  static FT polished(const W& w, const W& old, const FT& t, const FT& l, const FT& r)
  {
    const FT s = t - (w.distance(t) - old.distance(t)) / (w.slope(t) - old.slope(t));
    return s > l && s < r ? s : t;
  }

  // Whether `a`, which ends at a_end, and `b`, which begins at b_begin, are one window.
  BOOST_FORCEINLINE static bool can_join(const W& a, const FT& a_end, const W& b, const FT& b_begin)
  {
    return a.origin == b.origin && a_end == b_begin && a.pending && b.pending && Predicates::have_same_source(a, b);
  }

  std::vector<Piece> m_pieces;
  std::vector<W> m_old;
  FT m_nearest;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_ENVELOPE_H
