module n031_for (input wire [3:0] a, output wire b);
    genvar i;
    for (j = 0; j < 4; j = j + 1) begin : undeclared
        wire x = a[j];
    end
    for (i = 0; i < 4; i = i) begin : standing
        wire x = a[i];
    end
    for (i = 0; i >= 0; i = i + 1) begin : long
    end
    for (i = 0; i < 2; i = i + 1) begin : outer
        for (i = 0; i < 2; i = i + 1) begin : inner
        end
    end
    assign b = a[0];
endmodule
