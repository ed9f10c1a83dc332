namespace CreatureGen.Anatomy.Beaks;

/// <summary>Hens and finches: a short cone that ends in a point.</summary>
internal static class ConicalBeak
{
    /// <summary>Its form.</summary>
    public static readonly BeakForm Form = new()
    {
        Length = (0.24, 0.38), Hook = 0.25,
        Root = (5.3f, 5.7f, 4.7f),
        Upper = new BillForm { Ridge = (0.08f, 0.14f, 0.14f), Side = (0.05f, 0.07f, 0.08f), Keel = 3f, Close = (1.3f, 1.25f) },
        Lower = new BillForm { Ridge = (0.05f, 0.08f, 0.09f), Side = (0.04f, 0.04f, 0.05f), Notch = 0.4f, Close = (1.4f, 1.3f) },
        LowerLength = 0.8f,
        Nostril = (0.36f, 4f),
    };
}
