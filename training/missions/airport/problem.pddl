(define (problem evening) (:domain airport)
  (:objects tug - vehicle hall - hall belt-1 belt-2 - belt gate-5 gate-6 gate-7 - gate
    samsonite trunk guitar-case - suitcase)
  (:init (parked-at tug hall) (lane hall belt-1) (lane belt-1 hall) (lane hall belt-2)
    (lane belt-2 hall) (lane hall gate-5) (lane gate-5 hall) (lane hall gate-6) (lane gate-6 hall)
    (lane gate-6 gate-7) (lane gate-7 gate-6) (lying-on samsonite belt-1) (lying-on trunk belt-1)
    (lying-on guitar-case belt-2) (belt-jammed belt-2) (gate-closed gate-7))
  (:goal (and (delivered samsonite) (delivered trunk))))
