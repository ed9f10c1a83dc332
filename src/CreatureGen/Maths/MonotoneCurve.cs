namespace CreatureGen.Maths;

/// <summary>A curve through fixed values at fixed knots that never overshoots them (<see cref="MonotoneCubic"/>).</summary>
internal sealed class MonotoneCurve
{
    private readonly double[] knots;
    private readonly double[] values;
    private readonly double[] slopes;

    /// <summary>Takes the knots, strictly ascending, and as many finite values.</summary>
    /// <exception cref="System.ArgumentException">Their numbers differ or are less than 2, or the knots do not ascend.</exception>
    public MonotoneCurve(double[] knots, double[] values)
    {
        this.knots = knots;
        this.values = values;
        slopes = new double[values.Length];
        MonotoneCubic.Slopes(knots, values, slopes);
    }

    /// <summary>The value at <paramref name="x"/>, clamped to the ends.</summary>
    public double At(double x) => MonotoneCubic.Evaluate(knots, values, slopes, x);
}
