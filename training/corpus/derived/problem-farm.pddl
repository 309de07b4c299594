(define (problem farm-1)
  (:domain farm)
  (:objects
    bumble hornet - drone
    orchard greenhouse north-field - site
    pear-tree tomato barley - plant
    sensor1 sensor2 - sensor)
  (:init (drone-at bumble barn) (drone-at hornet pond)
    (grows pear-tree orchard) (grows tomato greenhouse) (grows barley north-field)
    (mounted sensor1 north-field) (mounted sensor2 greenhouse)
    (broken sensor1))
  (:goal (and (watered tomato) (watered barley))))
