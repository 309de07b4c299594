(define (problem tonight) (:domain museum)
  (:objects hugo - guard foyer gallery cabinet crypt - room vase portrait mummy - exhibit
    curator police - person)
  (:init (guard-in hugo foyer) (door foyer gallery) (door gallery foyer) (door gallery cabinet)
    (door cabinet gallery) (door foyer crypt) (door crypt foyer) (hangs-in vase cabinet)
    (hangs-in portrait gallery) (hangs-in mummy crypt) (lights-on gallery) (lights-on crypt)
    (window-open gallery))
  (:goal (and (patrolled gallery) (patrolled crypt) (informed curator))))
