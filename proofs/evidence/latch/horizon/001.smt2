; latch/horizon: ∀ limits, dt, answers a₀ … aₙ of the ticks: ¬faulty ⇒ (n > 0 ∧ ¬pos(dt) ⇔ held for it); else a₀ = err r ⇒ held for r; else kept = min{i: aᵢ₊₁ is err} ∪ {n}, limited ⇔ kept < n ∨ ∃ i ≤ kept: aᵢ changed
; Each answer has to be unsat, 34 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(define-fun t6 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t7 () Bool (fp.lt x0 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t9 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x0))
(define-fun t10 () Bool (and t6 t9))
(define-fun t12 () Bool (and t6 (not t7)))
(declare-const x1 Float64)
(define-fun t16 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t17 () Bool (fp.lt x1 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t19 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x1))
(define-fun t20 () Bool (and t16 t19))
(define-fun t22 () Bool (and t16 (not t17)))
(define-fun t24 () Bool (and (not t10) t22))
(define-fun t26 () Bool (and t12 (not t12)))
(define-fun t29 () Bool (and t22 (not t24)))
(push 1) ; a bad horizon holds
(assert t6)(assert t9)(assert (not t10))
(check-sat)
(pop 1)
(push 1) ; a bad horizon holds
(assert t6)(assert (not t7))(assert (not t12))
(check-sat)
(pop 1)
(push 1) ; a bad horizon holds
(assert (not t6))(assert (not (not t12)))
(check-sat)
(pop 1)
(push 1) ; a bad horizon holds
(assert t6)(assert t7)(assert (not (not t12)))
(check-sat)
(pop 1)
(push 1) ; a bad horizon holds
(assert (not t6))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; a bad horizon holds
(assert t6)(assert (not t9))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; a bad horizon holds
(assert (not t6))(assert t16)(assert (not t17))(assert (not t24))
(check-sat)
(pop 1)
(push 1) ; a bad horizon holds
(assert t6)(assert (not t9))(assert t16)(assert (not t17))(assert (not t24))
(check-sat)
(pop 1)
(push 1) ; a bad horizon holds
(assert t6)(assert t9)(assert t16)(assert (not t17))(assert (not (not t24)))
(check-sat)
(pop 1)
(push 1) ; a bad horizon holds
(assert (not t16))(assert (not (not t24)))
(check-sat)
(pop 1)
(push 1) ; a bad horizon holds
(assert t16)(assert t17)(assert (not (not t24)))
(check-sat)
(pop 1)
(push 1) ; a faulty limit holds
(assert t6)(assert (not t7))(assert (not t12))
(check-sat)
(pop 1)
(push 1) ; a faulty limit holds
(assert (not t6))(assert (not (not t12)))
(check-sat)
(pop 1)
(push 1) ; a faulty limit holds
(assert t6)(assert t7)(assert (not (not t12)))
(check-sat)
(pop 1)
(push 1) ; a faulty limit holds
(assert t16)(assert (not t17))(assert (not t22))
(check-sat)
(pop 1)
(push 1) ; a faulty limit holds
(assert (not t16))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; a faulty limit holds
(assert t16)(assert t17)(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; every kept tick was limited as configured
(assert t6)(assert t9)(assert (not t10))
(check-sat)
(pop 1)
(push 1) ; every kept tick was limited as configured
(assert t6)(assert (not t9))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; every kept tick was limited as configured
(assert t16)(assert t19)(assert (not t20))
(check-sat)
(pop 1)
(push 1) ; every kept tick was limited as configured
(assert t16)(assert (not t19))(assert (not (not t20)))
(check-sat)
(pop 1)
(push 1) ; ticks are kept up to the first that is not to be used
(assert (not t6))(assert (not (not t12)))
(check-sat)
(pop 1)
(push 1) ; ticks are kept up to the first that is not to be used
(assert t6)(assert t7)(assert (not (not t12)))
(check-sat)
(pop 1)
(push 1) ; ticks are kept up to the first that is not to be used
(assert (not t6))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; ticks are kept up to the first that is not to be used
(assert t6)(assert (not t9))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; ticks are kept up to the first that is not to be used
(assert (not t16))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; ticks are kept up to the first that is not to be used
(assert t16)(assert t17)(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; ticks are kept up to the first that is not to be used
(assert (not t6))(assert (not (not t26)))
(check-sat)
(pop 1)
(push 1) ; ticks are kept up to the first that is not to be used
(assert t6)(assert (not t7))(assert (not (not t26)))
(check-sat)
(pop 1)
(push 1) ; ticks are kept up to the first that is not to be used
(assert t6)(assert t7)(assert (not (not t26)))
(check-sat)
(pop 1)
(push 1) ; ticks are kept up to the first that is not to be used
(assert (not t6))(assert t16)(assert (not t17))(assert (not (not t29)))
(check-sat)
(pop 1)
(push 1) ; ticks are kept up to the first that is not to be used
(assert t6)(assert (not t9))(assert t16)(assert (not t17))(assert (not (not t29)))
(check-sat)
(pop 1)
(push 1) ; ticks are kept up to the first that is not to be used
(assert (not t16))(assert (not (not t29)))
(check-sat)
(pop 1)
(push 1) ; ticks are kept up to the first that is not to be used
(assert t16)(assert t17)(assert (not (not t29)))
(check-sat)
(pop 1)
