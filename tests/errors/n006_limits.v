module n006_limits (input wire a, output wire b);
    assign b = ((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((a))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))));
    wire [63:0] wide = {5000{a}};
    genvar i;
    genvar j;
    for (i = 0; i < 10000; i = i + 1) begin : outer
        for (j = 0; j < 10000; j = j + 1) begin : inner
            wire x;
        end
    end
endmodule
