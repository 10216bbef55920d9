; latch/gates: ∀ limits, states, commands: decision = first closed gate of 7.3; estop′ ⇔ estop ∨ mode = estop ∨ outside; note_link, reset as in 7.1
; Each answer has to be unsat, 400 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(declare-const x2 Float64)
(declare-const x3 Float64)
(declare-const x4 Float64)
(define-fun t9 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t10 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x0))
(define-fun t11 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t12 () Bool (not (or (fp.isNaN x2) (fp.isInfinite x2))))
(define-fun t13 () Bool (fp.leq x2 x1))
(define-fun t14 () Float64 (fp.sub RNE x1 x2))
(define-fun t16 () Float64 (fp.mul RNE t14 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t17 () Bool (fp.leq t16 x0))
(define-fun t18 () Bool (and t9 t10))
(define-fun t19 () Bool (and t11 t12))
(define-fun t20 () Bool (and t13 t19))
(define-fun t21 () Bool (and t18 t20))
(define-fun t22 () Bool (and t17 t21))
(declare-const x5 Float64)
(define-fun t25 () Bool (fp.lt x0 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t28 () Bool (and t9 (not t25)))
(define-fun t31 () Bool (and t28 (not t18)))
(define-fun t35 () Float64 (fp.mul RNE x4 x4))
(define-fun t37 () Float64 (fp.mul RNE x5 x5))
(define-fun t41 () Bool (not (or (fp.isNaN x3) (fp.isInfinite x3))))
(define-fun t42 () Bool (not (or (fp.isNaN x4) (fp.isInfinite x4))))
(define-fun t43 () Bool (not (or (fp.isNaN x5) (fp.isInfinite x5))))
(define-fun t44 () Bool (and t41 t42))
(define-fun t51 () Float64 (fp.sub RNE x2 x3))
(define-fun t52 () Float64 (fp.mul RNE t51 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t53 () Bool (fp.leq x3 x2))
(define-fun t54 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x1))
(define-fun t55 () Bool (and t11 t54))
(define-fun t56 () Bool (fp.leq t52 x1))
(define-fun t57 () Bool (and t12 t41))
(define-fun t58 () Bool (and t53 t57))
(define-fun t59 () Bool (and t55 t58))
(define-fun t60 () Bool (and t56 t59))
(define-fun t62 () Bool (and t31 (not t60)))
(define-fun t64 () Bool (and t31 t60))
(define-fun t65 () Bool (and t18 t64))
(define-fun t67 () Bool (and (not t18) t64))
(define-fun t68 () Bool (and t18 t67))
(declare-const x6 Float64)
(define-fun t72 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t35))
(define-fun t73 () Float64 (fp.add RNE t72 t37))
(define-fun t74 () Float64 (fp.mul RNE x6 x6))
(define-fun t75 () Float64 (fp.add RNE t73 t74))
(define-fun t76 () Float64 (fp.sqrt RNE t75))
(define-fun t77 () Bool (fp.leq t76 x0))
(define-fun t78 () Bool (not (or (fp.isNaN x6) (fp.isInfinite x6))))
(define-fun t79 () Bool (and t42 t43))
(define-fun t80 () Bool (and t78 t79))
(define-fun t81 () Bool (and t18 t80))
(define-fun t82 () Bool (and t77 t81))
(define-fun t84 () Bool (and t18 (not t82)))
(define-fun t85 () Bool (and t64 t84))
(define-fun t91 () Bool (and t28 (not t60)))
(define-fun t93 () Bool (and t28 t60))
(define-fun t94 () Bool (and t18 t93))
(define-fun t124 () Bool (fp.lt x1 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t127 () Bool (and t11 (not t124)))
(define-fun t129 () Bool (and t28 t127))
(define-fun t132 () Bool (and (not t18) (not t55)))
(define-fun t134 () Bool (and t129 t132))
(define-fun t142 () Float64 (fp.sub RNE x3 x4))
(define-fun t143 () Float64 (fp.mul RNE t142 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t144 () Bool (fp.leq x4 x3))
(define-fun t145 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x2))
(define-fun t146 () Bool (and t12 t145))
(define-fun t147 () Bool (fp.leq t143 x2))
(define-fun t148 () Bool (and t44 t144))
(define-fun t149 () Bool (and t146 t148))
(define-fun t150 () Bool (and t147 t149))
(define-fun t152 () Bool (and t134 (not t150)))
(define-fun t154 () Bool (and t134 t150))
(define-fun t155 () Bool (and t55 t154))
(define-fun t181 () Bool (and (not t18) t129))
(define-fun t183 () Bool (and (not t150) t181))
(define-fun t185 () Bool (and t150 t181))
(define-fun t186 () Bool (and t55 t185))
(define-fun t205 () Bool (and t129 (not t55)))
(define-fun t207 () Bool (and (not t150) t205))
(define-fun t209 () Bool (and t150 t205))
(define-fun t210 () Bool (and t55 t209))
(define-fun t221 () Bool (and t129 (not t150)))
(define-fun t223 () Bool (and t129 t150))
(define-fun t224 () Bool (and t55 t223))
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert (not t25))(assert (not t28))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert (not t9))(assert (not (not t28)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t25)(assert (not (not t28)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert (not t10))(assert (not t25))(assert (not t31))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert (not t9))(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t10)(assert (not t25))(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t25)(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t11)(assert (not t25))(assert (not t124))(assert (not t129))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert (not t9))(assert (not t11))(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert (not t9))(assert t11)(assert (not t124))(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert (not t9))(assert t11)(assert t124)(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert (not t11))(assert (not t25))(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert (not t11))(assert t25)(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t11)(assert (not t25))(assert t124)(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t11)(assert t25)(assert (not t124))(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not t134))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert (not t9))(assert (not t11))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert (not t9))(assert t11)(assert (not t54))(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert (not t9))(assert t11)(assert t54)(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert (not t9))(assert t11)(assert t124)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t124)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t124)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert (not t11))(assert t25)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t11)(assert t25)(assert (not t54))(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t11)(assert t25)(assert t54)(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t124))(assert (not t181))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert (not t9))(assert (not t11))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert (not t9))(assert t11)(assert (not t124))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert (not t9))(assert t11)(assert t124)(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t124)(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t124))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t124)(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert (not t11))(assert t25)(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t11)(assert t25)(assert (not t124))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t11)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not t205))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert (not t9))(assert (not t11))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert (not t9))(assert t11)(assert (not t54))(assert (not t124))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert (not t9))(assert t11)(assert t54)(assert (not t124))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert (not t9))(assert t11)(assert t124)(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert (not t11))(assert (not t25))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert (not t11))(assert t25)(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t11)(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t11)(assert (not t25))(assert t124)(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t11)(assert t25)(assert (not t54))(assert (not t124))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t11)(assert t25)(assert t54)(assert (not t124))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly by 7.2
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert (not t25))(assert (not t28))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert (not t9))(assert (not (not t28)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t25)(assert (not (not t28)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert (not t10))(assert (not t25))(assert (not t31))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert (not t9))(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t10)(assert (not t25))(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t25)(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t11)(assert (not t25))(assert (not t124))(assert (not t129))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert (not t9))(assert (not t11))(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert (not t9))(assert t11)(assert (not t124))(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert (not t9))(assert t11)(assert t124)(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert (not t11))(assert (not t25))(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert (not t11))(assert t25)(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t11)(assert (not t25))(assert t124)(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t11)(assert t25)(assert (not t124))(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not t134))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert (not t9))(assert (not t11))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert (not t9))(assert t11)(assert (not t54))(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert (not t9))(assert t11)(assert t54)(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert (not t9))(assert t11)(assert t124)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t124)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t124)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert (not t11))(assert t25)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t11)(assert t25)(assert (not t54))(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t11)(assert t25)(assert t54)(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t124))(assert (not t181))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert (not t9))(assert (not t11))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert (not t9))(assert t11)(assert (not t124))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert (not t9))(assert t11)(assert t124)(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t124)(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t124))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t124)(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert (not t11))(assert t25)(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t11)(assert t25)(assert (not t124))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t11)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not t205))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert (not t9))(assert (not t11))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert (not t9))(assert t11)(assert (not t54))(assert (not t124))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert (not t9))(assert t11)(assert t54)(assert (not t124))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert (not t9))(assert t11)(assert t124)(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert (not t11))(assert (not t25))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert (not t11))(assert t25)(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t11)(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t11)(assert (not t25))(assert t124)(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t11)(assert t25)(assert (not t54))(assert (not t124))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t11)(assert t25)(assert t54)(assert (not t124))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 2: config
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert t11)(assert t12)(assert t13)(assert t17)(assert (not t22))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert (not t11))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert t11)(assert (not t12))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t13))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert t11)(assert t12)(assert t13)(assert (not t17))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t25))(assert (not t28))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert (not (not t28)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t25)(assert (not (not t28)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert (not t25))(assert (not t31))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert (not t25))(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t25)(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not t62))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t54)(assert (not t62))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert t54)(assert (not t62))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t53))(assert t54)(assert (not t62))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t53)(assert t54)(assert (not t56))(assert (not t62))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t54))(assert (not t62))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t53)(assert t54)(assert t56)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert (not t25))(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t25)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t11))(assert (not t25))(assert (not t91))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert (not t12))(assert (not t25))(assert t54)(assert (not t91))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert t54)(assert (not t91))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t53))(assert t54)(assert (not t91))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t53)(assert t54)(assert (not t56))(assert (not t91))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert (not t25))(assert (not t54))(assert (not t91))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert (not (not t91)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t53)(assert t54)(assert t56)(assert (not (not t91)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t25)(assert (not (not t91)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert (not t25))(assert (not t124))(assert (not t129))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert (not t11))(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert (not t124))(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert t124)(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t11))(assert (not t25))(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t11))(assert t25)(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert (not t25))(assert t124)(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert (not t124))(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t129)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not t134))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert (not t11))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert (not t54))(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert t54)(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert t124)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t124)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t124)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t11))(assert t25)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert (not t54))(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert t54)(assert (not t124))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert (not t54))(assert (not t124))(assert (not t152))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert (not t54))(assert (not t124))(assert t145)(assert (not t152))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t42))(assert (not t54))(assert (not t124))(assert t145)(assert (not t152))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert (not t144))(assert t145)(assert (not t152))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert t144)(assert t145)(assert (not t147))(assert (not t152))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not t145))(assert (not t152))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert (not t11))(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert (not t54))(assert (not t124))(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert t54)(assert (not t124))(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert t124)(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert t144)(assert t145)(assert t147)(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t124)(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t124)(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t11))(assert t25)(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert (not t54))(assert (not t124))(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert t54)(assert (not t124))(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t124))(assert (not t181))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert (not t11))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert (not t124))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert t124)(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t124)(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t124))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t124)(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t11))(assert t25)(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert (not t124))(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t181)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert (not t124))(assert (not t183))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert (not t124))(assert t145)(assert (not t183))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t42))(assert (not t124))(assert t145)(assert (not t183))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t124))(assert (not t144))(assert t145)(assert (not t183))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t124))(assert t144)(assert t145)(assert (not t147))(assert (not t183))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t124))(assert (not t145))(assert (not t183))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert (not t11))(assert (not (not t183)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert (not t124))(assert (not (not t183)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert t124)(assert (not (not t183)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t183)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t124))(assert t144)(assert t145)(assert t147)(assert (not (not t183)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t124)(assert (not (not t183)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t183)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t124))(assert (not (not t183)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t124)(assert (not (not t183)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t11))(assert t25)(assert (not (not t183)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert (not t124))(assert (not (not t183)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t183)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not t205))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert (not t11))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert (not t54))(assert (not t124))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert t54)(assert (not t124))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert t124)(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t11))(assert (not t25))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t11))(assert t25)(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert (not t25))(assert t124)(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert (not t54))(assert (not t124))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert t54)(assert (not t124))(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t205)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert (not t12))(assert (not t25))(assert (not t54))(assert (not t124))(assert (not t207))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert (not t54))(assert (not t124))(assert t145)(assert (not t207))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t42))(assert (not t54))(assert (not t124))(assert t145)(assert (not t207))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert (not t144))(assert t145)(assert (not t207))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert t144)(assert t145)(assert (not t147))(assert (not t207))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not t145))(assert (not t207))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert (not t11))(assert (not (not t207)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert (not t54))(assert (not t124))(assert (not (not t207)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert t54)(assert (not t124))(assert (not (not t207)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert t124)(assert (not (not t207)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t11))(assert (not t25))(assert (not (not t207)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t11))(assert t25)(assert (not (not t207)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert t144)(assert t145)(assert t147)(assert (not (not t207)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t207)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert (not t25))(assert t124)(assert (not (not t207)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert (not t54))(assert (not t124))(assert (not (not t207)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert t54)(assert (not t124))(assert (not (not t207)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t207)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert (not t12))(assert (not t25))(assert (not t124))(assert (not t221))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert (not t124))(assert t145)(assert (not t221))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t42))(assert (not t124))(assert t145)(assert (not t221))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t124))(assert (not t144))(assert t145)(assert (not t221))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t124))(assert t144)(assert t145)(assert (not t147))(assert (not t221))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t124))(assert (not t145))(assert (not t221))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert (not t11))(assert (not (not t221)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert (not t124))(assert (not (not t221)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert (not t9))(assert t11)(assert t124)(assert (not (not t221)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t11))(assert (not t25))(assert (not (not t221)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert (not t11))(assert t25)(assert (not (not t221)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t124))(assert t144)(assert t145)(assert t147)(assert (not (not t221)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert (not t25))(assert t124)(assert (not (not t221)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert (not t124))(assert (not (not t221)))
(check-sat)
(pop 1)
(push 1) ; gate 3: stale
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t221)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert (not (not t65)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t65)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t54)(assert (not (not t65)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert t54)(assert (not (not t65)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t53))(assert t54)(assert (not (not t65)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t53)(assert t54)(assert (not t56))(assert (not (not t65)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t53)(assert t54)(assert t56)(assert (not (not t65)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t54))(assert (not (not t65)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t10)(assert (not t25))(assert (not (not t65)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t25)(assert (not (not t65)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t53)(assert t54)(assert t56)(assert (not t94))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert (not (not t94)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t94)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t54)(assert (not (not t94)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert t54)(assert (not (not t94)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t53))(assert t54)(assert (not (not t94)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t53)(assert t54)(assert (not t56))(assert (not (not t94)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t53)(assert t54)(assert t56)(assert (not (not t94)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t54))(assert (not (not t94)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t94)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t10)(assert t11)(assert (not t12))(assert (not t25))(assert t54)(assert (not (not t94)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert t54)(assert (not (not t94)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t53))(assert t54)(assert (not (not t94)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t53)(assert t54)(assert (not t56))(assert (not (not t94)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t54))(assert (not (not t94)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t25)(assert (not (not t94)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert (not t11))(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert t11)(assert (not t54))(assert (not t124))(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert t11)(assert t54)(assert (not t124))(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert t11)(assert t124)(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert (not t54))(assert (not t124))(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert (not t54))(assert (not t124))(assert t145)(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t42))(assert (not t54))(assert (not t124))(assert t145)(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert (not t144))(assert t145)(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert t144)(assert t145)(assert (not t147))(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert t144)(assert t145)(assert t147)(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not t145))(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t124)(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t124)(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t11))(assert t25)(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t25)(assert (not t54))(assert (not t124))(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t25)(assert t54)(assert (not t124))(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert t54)(assert (not t124))(assert t144)(assert t145)(assert t147)(assert (not t186))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert (not t11))(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert t11)(assert (not t54))(assert (not t124))(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert t11)(assert t54)(assert (not t124))(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert t11)(assert t124)(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert (not t54))(assert (not t124))(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert (not t54))(assert (not t124))(assert t145)(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert t54)(assert (not t124))(assert t145)(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t42))(assert (not t54))(assert (not t124))(assert t145)(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t42))(assert t54)(assert (not t124))(assert t145)(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert (not t144))(assert t145)(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert t144)(assert t145)(assert (not t147))(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert t144)(assert t145)(assert t147)(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert t54)(assert (not t124))(assert (not t144))(assert t145)(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert t54)(assert (not t124))(assert t144)(assert t145)(assert (not t147))(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not t145))(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t54)(assert (not t124))(assert (not t145))(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t124)(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t124)(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t11))(assert t25)(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t25)(assert (not t54))(assert (not t124))(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t25)(assert t54)(assert (not t124))(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t186)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert (not t11))(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert t11)(assert (not t54))(assert (not t124))(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert t11)(assert t54)(assert (not t124))(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert t11)(assert t124)(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t11))(assert (not t25))(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t11))(assert t25)(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert (not t12))(assert (not t25))(assert (not t54))(assert (not t124))(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert (not t54))(assert (not t124))(assert t145)(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t42))(assert (not t54))(assert (not t124))(assert t145)(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert (not t144))(assert t145)(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert t144)(assert t145)(assert (not t147))(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert t144)(assert t145)(assert t147)(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not t145))(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert (not t25))(assert t124)(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t25)(assert (not t54))(assert (not t124))(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t25)(assert t54)(assert (not t124))(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t210)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert t54)(assert (not t124))(assert t144)(assert t145)(assert t147)(assert (not t224))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert (not t11))(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert t11)(assert (not t54))(assert (not t124))(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert t11)(assert t54)(assert (not t124))(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert (not t9))(assert t11)(assert t124)(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t11))(assert (not t25))(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert (not t11))(assert t25)(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert (not t12))(assert (not t25))(assert (not t54))(assert (not t124))(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert (not t12))(assert (not t25))(assert t54)(assert (not t124))(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert (not t54))(assert (not t124))(assert t145)(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert t54)(assert (not t124))(assert t145)(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t42))(assert (not t54))(assert (not t124))(assert t145)(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t42))(assert t54)(assert (not t124))(assert t145)(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert (not t144))(assert t145)(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert t144)(assert t145)(assert (not t147))(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert (not t54))(assert (not t124))(assert t144)(assert t145)(assert t147)(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert t54)(assert (not t124))(assert (not t144))(assert t145)(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t42)(assert t54)(assert (not t124))(assert t144)(assert t145)(assert (not t147))(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t54))(assert (not t124))(assert (not t145))(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t54)(assert (not t124))(assert (not t145))(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert (not t25))(assert t124)(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t25)(assert (not t54))(assert (not t124))(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t25)(assert t54)(assert (not t124))(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: no position
(assert t9)(assert t11)(assert t25)(assert t124)(assert (not (not t224)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t54)(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert t54)(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t53))(assert t54)(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t53)(assert t54)(assert (not t56))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert t53)(assert t54)(assert t56)(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t54))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert (not t25))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t25)(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert (not (not t85)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t85)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t54)(assert (not (not t85)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t41))(assert t54)(assert (not (not t85)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t41)(assert (not t53))(assert t54)(assert (not (not t85)))
(check-sat)
(pop 1)
