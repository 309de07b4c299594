(define (problem stage-1)
  (:domain theatre-stage)
  (:objects
    figaro - stagehand
    right-wing dressing-room - spot
    throne sword mirror - prop
    spotlight footlight - lamp)
  (:init (is-at figaro dressing-room) (free figaro)
    (prop-in throne right-wing) (prop-in sword dressing-room) (prop-in mirror dressing-room)
    (adjacent dressing-room left-wing) (adjacent left-wing dressing-room)
    (adjacent left-wing trapdoor) (adjacent trapdoor left-wing)
    (adjacent trapdoor right-wing) (adjacent right-wing trapdoor)
    (adjacent left-wing balcony) (adjacent balcony left-wing))
  (:goal (and (curtain-up) (lit spotlight))))
