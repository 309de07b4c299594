(define (problem greenhouse-day)
  (:domain greenhouse)
  (:objects
    shed nursery terrace cellar - place
    fern orchid tomato basil - plant)
  (:init
    (robot-at nursery) (hands-free)
    (plant-in fern shed) (plant-in orchid nursery) (plant-in tomato nursery) (plant-in basil cellar)
    (needs-water fern) (needs-water tomato)
    (door-open nursery) (door-open terrace) (door-shut shed) (door-shut cellar)
    (path-between shed nursery) (path-between nursery shed)
    (path-between nursery terrace) (path-between terrace nursery)
    (path-between nursery cellar) (path-between cellar nursery)
    (path-between terrace cellar) (path-between cellar terrace))
  (:goal (and (plant-in fern terrace))))
