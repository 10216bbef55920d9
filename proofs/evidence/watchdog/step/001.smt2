; watchdog/step: init = model.init; ∀ reachable states σ, events e: step(σ, e) = model.step(σ, e), where σ ∈ {(none, none), (q, (r, ttl)), (q, none)} for all q ∈ I64, r, ttl ∈ F64
; Each answer has to be unsat, 20 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(declare-const q0 (_ BitVec 64))
(define-fun t5 () Bool (= q0 (_ bv0 64)))
(declare-const x2 Float64)
(declare-const q1 (_ BitVec 64))
(define-fun t10 () Bool (bvslt q0 q1))
(define-fun t12 () Bool (= q1 (_ bv0 64)))
(define-fun t13 () Bool (bvslt q1 q0))
(define-fun t16 () Bool (and t13 (not t12)))
(define-fun t18 () Bool (and t10 (not t12)))
(define-fun t19 () Bool (= q0 q1))
(define-fun t20 () Bool (and t18 t19))
(define-fun t23 () Bool (and t18 (not t20)))
(define-fun t25 () Bool (= q1 q0))
(define-fun t26 () Bool (and (not t18) t25))
(define-fun t28 () Bool (and (not t18) (not t26)))
(define-fun t30 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t32 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x1))
(define-fun t34 () Bool (fp.lt x1 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t35 () Bool (not (or (fp.isNaN x2) (fp.isInfinite x2))))
(define-fun t36 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t37 () Bool (fp.leq x0 x2))
(define-fun t38 () Float64 (fp.sub RNE x2 x0))
(define-fun t40 () Float64 (fp.mul RNE t38 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t41 () Bool (fp.leq t40 x1))
(define-fun t42 () Bool (and t30 t32))
(define-fun t43 () Bool (fp.leq t40 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t44 () Bool (and t35 t36))
(define-fun t45 () Bool (and t37 t44))
(define-fun t46 () Bool (and t42 t45))
(define-fun t47 () Bool (and t41 t46))
(define-fun t48 () Bool (and t43 t47))
(push 1) ; a HOLD is never ignored
(assert (not t12))(assert t13)(assert (not t16))
(check-sat)
(pop 1)
(push 1) ; a HOLD is never ignored
(assert (not t12))(assert (not t13))(assert (not (not t16)))
(check-sat)
(pop 1)
(push 1) ; a HOLD is never ignored
(assert t12)(assert (not (not t16)))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert t5)(assert (not t5))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert (not t5))(assert (not (not t5)))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert (not t10))(assert (not t12))(assert (not (not t23)))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert (not t10))(assert t12)(assert (not (not t23)))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert t10)(assert t12)(assert (not (not t23)))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert t10)(assert (not t12))(assert (not (not t28)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t30)(assert t32)(assert (not t34))(assert t35)(assert t36)(assert t37)(assert t43)(assert (not t48))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t30)(assert t32)(assert t34)(assert t35)(assert t36)(assert t37)(assert t41)(assert (not t48))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert (not t30))(assert (not (not t48)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t30)(assert (not t32))(assert (not (not t48)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t30)(assert t32)(assert (not t35))(assert (not (not t48)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t30)(assert t32)(assert t35)(assert (not t36))(assert (not (not t48)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t30)(assert t32)(assert t35)(assert t36)(assert (not t37))(assert (not (not t48)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t30)(assert t32)(assert t35)(assert t36)(assert t37)(assert (not t41))(assert (not (not t48)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t30)(assert t32)(assert t35)(assert t36)(assert t37)(assert (not t43))(assert (not (not t48)))
(check-sat)
(pop 1)
(push 1) ; only an advancing command refreshes
(assert t10)(assert (not t10))
(check-sat)
(pop 1)
(push 1) ; only an advancing command refreshes
(assert (not t10))(assert (not (not t10)))
(check-sat)
(pop 1)
