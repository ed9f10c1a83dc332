namespace CreatureGen.Anatomy.Feet;

/// <summary>What a foot is made of as numbers: factors on the toes that the form of the leg gives it.</summary>
internal sealed record FootForm
{
    /// <summary>Length of the toes.</summary>
    public float Length { get; init; } = 1;

    /// <summary>Angle between them.</summary>
    public float Splay { get; init; } = 1;

    /// <summary>Their radius behind the root, before the tip and at the tip.</summary>
    public (float Middle, float Ball, float Tip) Radius { get; init; } = (1, 1, 1);

    /// <summary>How far along the toes a web between them reaches, 0 for none.</summary>
    public float Web { get; init; }

    /// <summary>Length of the toe that points back, in lengths of the others; 0 for none.</summary>
    public float Hallux { get; init; }

    /// <summary>Whether flat nails take the place of claws.</summary>
    public bool Nailed { get; init; }

    /// <summary>Depth of the cleft of a hoof, in its radii.</summary>
    public float Cleft { get; init; }

    /// <summary>The form of a style.</summary>
    public static FootForm Of(FootStyle style) => style switch
    {
        FootStyle.Paw => PawFoot.Form,
        FootStyle.Web => WebFoot.Form,
        FootStyle.Talon => TalonFoot.Form,
        FootStyle.Sucker => SuckerFoot.Form,
        FootStyle.Stump => StumpFoot.Form,
        FootStyle.Cloven => ClovenFoot.Form,
        _ => PlainFoot.Form,
    };
}
