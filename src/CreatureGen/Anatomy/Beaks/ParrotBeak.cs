namespace CreatureGen.Anatomy.Beaks;

/// <summary>Parrots: high and round from the root, a hook that ends below the chin, a narrow cere.</summary>
internal static class ParrotBeak
{
    /// <summary>Its form.</summary>
    public static readonly BeakForm Form = new()
    {
        Length = (0.28, 0.4), Hook = 1.0,
        Root = (5.1f, 4.9f, 4.1f),
        Upper = new BillForm { Ridge = (0.1f, 0.26f, 0.26f), Side = (0.08f, 0.13f, 0.12f), Keel = 4f, Notch = 0.5f, Close = (1.7f, 1.5f) },
        Lower = new BillForm { Ridge = (0.06f, 0.12f, 0.12f), Side = (0.05f, 0.07f, 0.07f), Notch = 0.3f, Close = (2.2f, 1.8f) },
        LowerLength = 0.3f,
        Cere = 0.2f,
        Nostril = (0.1f, 3.2f),
        TipMark = 0.25f, TipShade = 0.6f,
    };
}
