; Four lines side by side and a warehouse, joined by the track that runs round them.
(define (problem four-lines)
  (:domain vineyard)
  (:objects
    rob - harvester
    sup - support
    l0 l1 l2 l3 - line
    wh - warehouse
    g0 g1 g2 g3 - grape
    b - box)
  (:init
    (robot-at rob l0) (robot-at sup wh)
    (carries rob b) (hand-empty rob)
    (adjacent wh l0) (adjacent l0 wh)
    (adjacent l0 l1) (adjacent l1 l0)
    (adjacent l1 l2) (adjacent l2 l1)
    (adjacent l2 l3) (adjacent l3 l2)
    (adjacent l3 wh) (adjacent wh l3)
    (grape-at g0 l0) (grape-at g1 l1) (grape-at g2 l2) (grape-at g3 l3)
    (unchecked g0) (unchecked g1) (unchecked g2) (unchecked g3))
  (:goal (and (cleared l0) (cleared l1) (cleared l2) (cleared l3)))
)
