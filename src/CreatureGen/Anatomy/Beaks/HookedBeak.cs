namespace CreatureGen.Anatomy.Beaks;

/// <summary>Birds of prey: a soft cere at the root, a culmen that arches, and a hook that falls over the lower bill.</summary>
internal static class HookedBeak
{
    /// <summary>Its form.</summary>
    public static readonly BeakForm Form = new()
    {
        Length = (0.24, 0.34), Hook = 0.7,
        Root = (5.4f, 5.4f, 4.5f),
        Upper = new BillForm { Ridge = (0.08f, 0.2f, 0.2f), Side = (0.06f, 0.08f, 0.1f), Keel = 2.6f, Close = (1.6f, 1.4f) },
        Lower = new BillForm { Ridge = (0.05f, 0.06f, 0.06f), Side = (0.04f, 0.04f, 0.05f), Notch = 0.4f, Close = (1.8f, 1.5f) },
        LowerLength = 0.35f,
        Cere = 0.36f,
        Nostril = (0.2f, 4.2f),
        TipMark = 0.3f, TipShade = 0.4f,
    };
}
