namespace CreatureGen.Anatomy;

/// <summary>What a leg with toes or a hoof ends in.</summary>
public enum FootStyle
{
    /// <summary>As the form of the leg gives it.</summary>
    Plain,

    /// <summary>Short round toes (cat, bear).</summary>
    Paw,

    /// <summary>Long toes with a web between them (duck, otter).</summary>
    Web,

    /// <summary>Slender grasping toes with long claws and one that points back (eagle).</summary>
    Talon,

    /// <summary>Thin toes with a disc at the end of each (tree frog, gecko).</summary>
    Sucker,

    /// <summary>A thick sole from which nothing but nails looks out (tapir, hippopotamus).</summary>
    Stump,

    /// <summary>A hoof in two halves (cow, pig, deer).</summary>
    Cloven,
}
