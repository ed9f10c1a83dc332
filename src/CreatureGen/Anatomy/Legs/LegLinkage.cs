namespace CreatureGen.Anatomy.Legs;

/// <summary>How the three bones of a leg share the work.</summary>
internal enum LegLinkage
{
    /// <summary>Thigh and metatarsus turn together.</summary>
    Pantograph,

    /// <summary>The foot has its own angle to the ground; thigh and shank reach for the ankle.</summary>
    Foot,
}
