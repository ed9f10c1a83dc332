namespace CreatureGen.Motion.Falling;

/// <summary>How a body rolls onto its flank as it goes limp, as data.</summary>
/// <param name="Side">The side to which it falls over if nothing else decides: 1 left, −1 right; 0 for what lies on its belly.</param>
/// <param name="Roll">How fast it rolls, 1/τ² with τ = √(ℓ/g).</param>
/// <param name="Time">How long that goes on, τ.</param>
/// <param name="Least">Speed at which it went below which it sinks down where it stands, unless something strikes it, √(gℓ).</param>
internal readonly record struct ToppleManner(float Side, float Roll, float Time, float Least)
{
    /// <summary>Of four legs or more.</summary>
    private static readonly ToppleManner manyLegs = new(1f, 1.6f, 2.5f, 0f);

    /// <summary>Of two, which sit down on their folded legs and their tail first, and lean on both for longer.</summary>
    private static readonly ToppleManner twoLegs = new(1f, 2.6f, 4f, 0.05f);

    /// <summary>Legs from which on a body is of the first kind, and of the second.</summary>
    private const int ManyLegs = 4;
    private const int TwoLegs = 2;

    /// <summary>Whether it rolls.</summary>
    public bool Topples => Side != 0f;

    /// <summary>That of a body: none without legs, or with legs out to the side, on which it comes to lie on its belly.</summary>
    /// <param name="legs">Its legs.</param>
    /// <param name="seed">Decides the side.</param>
    public static ToppleManner Of(LyingLeg[] legs, ulong seed)
    {
        foreach (LyingLeg leg in legs)
        {
            if (leg.Lateral)
            {
                return default;
            }
        }

        return legs.Length < TwoLegs ? default : (legs.Length < ManyLegs ? twoLegs : manyLegs) with { Side = (seed & 1) == 0 ? 1f : -1f };
    }
}
