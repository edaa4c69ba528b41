module n033_parts (input wire a, output wire b);
    genvar i;
    genvar j;
    for (i = 0; i < 10000; i = i + 1) begin : outer
        for (j = 0; j < 10000; j = j + 1) begin : inner
            wire x;
        end
    end
endmodule
