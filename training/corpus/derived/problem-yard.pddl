(define (problem yard-1)
  (:domain recycling-yard)
  (:objects
    rusty - sorter
    scrap_heap glass_corner weighbridge - area
    bale1 bale2 - bale
    red_container blue_container - container)
  (:init (sorter_at rusty entrance) (gripper_empty rusty)
    (bale_at bale1 scrap_heap) (bale_at bale2 scrap_heap)
    (in_area red_container glass_corner) (in_area blue_container scrap_heap)
    (full red_container)
    (path entrance weighbridge) (path weighbridge entrance)
    (path weighbridge scrap_heap) (path scrap_heap weighbridge)
    (path weighbridge glass_corner) (path glass_corner weighbridge)
    (path scrap_heap press_hall) (path press_hall scrap_heap))
  (:goal (press_running)))
