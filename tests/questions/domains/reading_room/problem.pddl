; Three returned books, two shelves and one desk.
(define (problem evening-returns)
  (:domain reading-room)
  (:objects
    page - robot
    desk - desk
    poetry-shelf history-shelf - shelf
    atlas diary sonnets - book)
  (:init
    (robot-at page desk)
    (aisle desk poetry-shelf) (aisle poetry-shelf desk)
    (aisle poetry-shelf history-shelf) (aisle history-shelf poetry-shelf)
    (belongs-on atlas history-shelf) (belongs-on diary history-shelf)
    (belongs-on sonnets poetry-shelf)
    (on-desk atlas) (on-desk diary) (on-desk sonnets))
  (:goal (and (shelved atlas) (shelved diary) (shelved sonnets)))
)
