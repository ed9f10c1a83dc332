namespace CreatureGen.Geometry;

/// <summary>What a piece set into the skin feels like: how it scatters light when the creature has a texture atlas.</summary>
internal enum SurfaceFinish
{
    /// <summary>Like skin.</summary>
    Skin,

    /// <summary>Horn, claw, nail, hoof.</summary>
    Horn,

    /// <summary>Tooth.</summary>
    Tooth,

    /// <summary>A wet eyeball.</summary>
    Eye,

    /// <summary>An insect's wing.</summary>
    Wing,

    /// <summary>Hair.</summary>
    Hair,
}
