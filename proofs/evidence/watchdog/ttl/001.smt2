; watchdog/ttl: ∀ ttl ∈ F64: enforced(ttl) is some t ⇔ fin(ttl) ∧ 0 < ttl; and t = min(ttl, 60000)
; Each answer has to be unsat, 5 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(define-fun t1 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t3 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x0))
(define-fun t5 () Bool (fp.lt x0 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t6 () Bool (and t1 t3))
(define-fun t10 () Bool (fp.leq x0 x0))
(define-fun t11 () Bool (fp.leq x0 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t12 () Bool (and t10 t11))
(define-fun t13 () Bool (fp.leq (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000) x0))
(push 1) ; at most the ttl and 60 s
(assert t1)(assert t3)(assert t5)(assert (not t12))
(check-sat)
(pop 1)
(push 1) ; at most the ttl and 60 s
(assert t1)(assert t3)(assert (not t5))(assert (not t13))
(check-sat)
(pop 1)
(push 1) ; none for what is no time
(assert t1)(assert t3)(assert (not t6))
(check-sat)
(pop 1)
(push 1) ; none for what is no time
(assert (not t1))(assert (not (not t6)))
(check-sat)
(pop 1)
(push 1) ; none for what is no time
(assert t1)(assert (not t3))(assert (not (not t6)))
(check-sat)
(pop 1)
