namespace CreatureGen.Anatomy.Beaks;

/// <summary>Herons and ibises: long and thin down to a fine point.</summary>
internal static class ProbeBeak
{
    /// <summary>Its form.</summary>
    public static readonly BeakForm Form = new()
    {
        Length = (0.45, 0.95), Hook = 0.3,
        Root = (5.2f, 5.8f, 4.9f),
        Upper = new BillForm { Ridge = (0.06f, 0.11f, 0.12f), Side = (0.04f, 0.07f, 0.1f), Keel = 2f, Notch = 0.9f, Close = (1.15f, 1.15f) },
        Lower = new BillForm { Ridge = (0.05f, 0.08f, 0.1f), Side = (0.04f, 0.05f, 0.07f), Notch = 0.4f, Close = (1.15f, 1.15f) },
        LowerLength = 0.94f,
        Nostril = (0.26f, 5f),
        TipMark = 0.2f, TipShade = 0.6f,
    };
}
