(define (problem night) (:domain bakery)
  (:objects rye baguette brioche focaccia - bread big-oven small-oven - oven tray-1 tray-2 - tray)
  (:init (hot small-oven) (on-tray rye tray-1) (on-tray brioche tray-2))
  (:goal (and (boxed rye) (boxed brioche))))
