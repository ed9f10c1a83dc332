using CreatureGen.Seeding;

namespace CreatureGen.Sampling.Placement;

/// <summary>Factors on the size of a part.</summary>
/// <param name="X">Across the body: span of a wing, thickness of a fin on the midline, length of a paired fin.</param>
/// <param name="Y">Upward: height of a fin on the midline, camber of a wing.</param>
/// <param name="Z">Along the body: chord of a wing, length of a fin's root.</param>
internal readonly record struct PartScale(double X, double Y, double Z);

/// <summary>The range that factors are drawn from.</summary>
/// <param name="Smallest">Least factor.</param>
/// <param name="Largest">Greatest factor.</param>
internal readonly record struct ScaleRange(double Smallest, double Largest)
{
    /// <summary>Three independent factors.</summary>
    public PartScale DrawEach(RandomStream stream) => new(Draw(stream), Draw(stream), Draw(stream));

    /// <summary>One factor for all three directions.</summary>
    public PartScale DrawUniform(RandomStream stream)
    {
        double factor = Draw(stream);
        return new PartScale(factor, factor, factor);
    }

    private double Draw(RandomStream stream) => stream.Uniform(Smallest, Largest);
}
