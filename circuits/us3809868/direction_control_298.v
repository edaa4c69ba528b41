`default_nettype none

// Direction control 298 of US 3,809,868, FIG. 9 (308 is the same with L and M), from gates. With the quadrants coded
// 00, 01, 10, 11 as q1 q0 and N a coefficient's sign bit, the count-up table of the patent is
//
//   quadrant | cosine pulse counts up if J is | sine pulse counts up if K is
//      1     |               -                |              +
//      2     |               -                |              -
//      3     |               +                |              -
//      4     |               +                |              +
//
//   cosine up = q1 xor N,   sine up = not (q1 xor q0 xor N)      (two SN7486 of the period and some NANDs)
//
// The print lost most signs of the table; they are restored from d(cos) < 0 in quadrants 1, 2 and d(sin) > 0 in
// quadrants 1, 4. Only the coefficient of the generator whose half of the clock it is gets tested (claim 15).
module direction_control_298 (
    input wire [1:0] quadrant,     // quadrant less one
    input wire negative_cosine,    // sign of J
    input wire negative_sine,      // sign of K
    input wire cosine,             // 1: the half of the clock for pulses of generator 272
    output wire up
);
    wire cosine_up, sine_falls, sine_up, sine;
    wire cosine_selected, sine_selected;

    xor xor_cosine_up (cosine_up, quadrant[1], negative_cosine);
    xor xor_sine_falls (sine_falls, quadrant[1], quadrant[0]);
    xnor xnor_sine_up (sine_up, sine_falls, negative_sine);
    not not_cosine (sine, cosine);
    nand nand_cosine (cosine_selected, cosine_up, cosine);
    nand nand_sine (sine_selected, sine_up, sine);
    nand nand_up (up, cosine_selected, sine_selected);
endmodule
