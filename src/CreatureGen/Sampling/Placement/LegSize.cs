namespace CreatureGen.Sampling.Placement;

/// <summary>How large the legs of one creature are beside what its anatomy says. The length of a standing leg is no choice: it is the distance to the ground.</summary>
/// <param name="Girth">Factor on the radius of the root.</param>
/// <param name="Reach">Factor on how far out splayed legs stand.</param>
/// <param name="Foot">Factor on the foot.</param>
/// <param name="Toes">Number of toes; sockets grow to make room for three and more.</param>
internal readonly record struct LegSize(double Girth, double Reach, double Foot, int Toes)
{
    /// <summary>Legs as the anatomy says, with the large feet that read well from afar.</summary>
    public static LegSize Nominal { get; } = new(Girth: 1, Reach: 1, Foot: 1.25, Toes: 3);
}
