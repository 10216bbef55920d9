; clamp/tick: limit_tick(channels, limit) is ok ⇔ ¬faulty ∧ fin(channels) ∧ (enabled ⇒ velocity is named, 3 wide, in m/s); and then ∀ c in m/s: ‖c‖ ≤ max
; Each answer has to be unsat, 13 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(declare-const x2 Float64)
(declare-const x3 Float64)
(define-fun t5 () Bool (not (or (fp.isNaN x3) (fp.isInfinite x3))))
(define-fun t6 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t7 () Bool (not (or (fp.isNaN x2) (fp.isInfinite x2))))
(define-fun t9 () Bool (and t6 t7))
(define-fun t10 () Bool (and t5 t9))
(declare-const x4 Float64)
(define-fun t14 () Bool (not (or (fp.isNaN x4) (fp.isInfinite x4))))
(define-fun t15 () Bool (and t10 t14))
(define-fun t21 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t22 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x0))
(define-fun t27 () Bool (and t21 t22))
(define-fun t141 () Bool (and t15 t27))
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t21))(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert t14)(assert t21)(assert (not t22))(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert (not t21))(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert t21)(assert (not t22))(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t6))(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t6))(assert t14)(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t6))(assert t14)(assert t21)(assert t22)(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t6)(assert (not t7))(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t6)(assert (not t7))(assert t14)(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t6)(assert (not t7))(assert t14)(assert t21)(assert t22)(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t14))(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t14)(assert (not t21))(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t14)(assert t21)(assert (not t22))(assert (not (not t141)))
(check-sat)
(pop 1)
