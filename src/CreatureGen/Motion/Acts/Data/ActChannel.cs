namespace CreatureGen.Motion;

/// <summary>
/// What an act moves, in words that every body knows: parts of the body instead of joints. Lengths are in leg lengths (of creatures without legs a sixth of their length), angles in radians, both away from
/// what the creature does by itself. The side of an act is its left, or its right where it is performed mirrored. A part that a body has not, or has not so far, does what it can.
/// </summary>
public enum ActChannel
{
    /// <summary>The trunk ahead.</summary>
    Ahead,

    /// <summary>The trunk to the act's side.</summary>
    Aside,

    /// <summary>The trunk up.</summary>
    Up,

    /// <summary>The trunk turned to the act's side.</summary>
    Yaw,

    /// <summary>The trunk tipped nose up about the hips, or nose down about the shoulders.</summary>
    Pitch,

    /// <summary>The trunk rolled, the act's side up.</summary>
    Roll,

    /// <summary>The chest let down: 0 as it stands, 1 until the belly is on the ground, or as far as its legs fold. Of a crawler what it carries raised: 0 as it does, 1 laid along the ground.</summary>
    ForeDown,

    /// <summary>The hips let down, in the same measure.</summary>
    HindDown,

    /// <summary>The back bent up from hips to chest.</summary>
    BackPitch,

    /// <summary>The back bent to the act's side.</summary>
    BackSide,

    /// <summary>The back twisted, the act's side of the chest up.</summary>
    BackTwist,

    /// <summary>The neck bent up, all of it together.</summary>
    NeckPitch,

    /// <summary>The neck bent to the act's side.</summary>
    NeckSide,

    /// <summary>The neck twisted, the act's side up.</summary>
    NeckTwist,

    /// <summary>The head raised on the neck.</summary>
    HeadPitch,

    /// <summary>The head turned to the act's side.</summary>
    HeadSide,

    /// <summary>The head tilted, the act's side up.</summary>
    HeadRoll,

    /// <summary>The jaw: 0 as at rest, 1 wide open.</summary>
    Jaw,

    /// <summary>The lids: 0 as at rest, 1 shut; below 0 wide open.</summary>
    Lids,

    /// <summary>The ears, and feelers like them: 1 laid flat back, −1 pricked ahead.</summary>
    Ears,

    /// <summary>The tail raised, all of it together.</summary>
    TailPitch,

    /// <summary>The tail bent to the act's side.</summary>
    TailSide,

    /// <summary>The outer half of the tail raised on top.</summary>
    TailCurl,

    /// <summary>Both arms swung ahead.</summary>
    ArmsAhead,

    /// <summary>Both arms spread.</summary>
    ArmsOut,

    /// <summary>Both elbows bent.</summary>
    ArmsBend,

    /// <summary>The arm of the act's side swung ahead, on top.</summary>
    ArmAhead,

    /// <summary>The arm of the act's side spread.</summary>
    ArmOut,

    /// <summary>The elbow of the act's side bent.</summary>
    ArmBend,

    /// <summary>Wings, and the paired fins of swimmers, spread and raised: 0 as they are, 1 as far as they go.</summary>
    Wings,

    /// <summary>The foremost pair of feet off the ground.</summary>
    ForeFeetUp,

    /// <summary>The foremost pair of feet ahead.</summary>
    ForeFeetAhead,

    /// <summary>The foremost pair of feet apart.</summary>
    ForeFeetOut,

    /// <summary>The foremost pair of feet with their toes down.</summary>
    ForeFeetPitch,

    /// <summary>The fore foot of the act's side off the ground, on top.</summary>
    ForeFootUp,

    /// <summary>The fore foot of the act's side ahead.</summary>
    ForeFootAhead,

    /// <summary>The fore foot of the act's side outward.</summary>
    ForeFootOut,

    /// <summary>The fore foot of the act's side with its toes down.</summary>
    ForeFootPitch,

    /// <summary>The rearmost pair of feet off the ground.</summary>
    HindFeetUp,

    /// <summary>The rearmost pair of feet ahead.</summary>
    HindFeetAhead,

    /// <summary>The rearmost pair of feet apart.</summary>
    HindFeetOut,

    /// <summary>The rearmost pair of feet with their toes down.</summary>
    HindFeetPitch,

    /// <summary>The hind foot of the act's side off the ground, on top.</summary>
    HindFootUp,

    /// <summary>The hind foot of the act's side ahead.</summary>
    HindFootAhead,

    /// <summary>The hind foot of the act's side outward.</summary>
    HindFootOut,

    /// <summary>The hind foot of the act's side with its toes down.</summary>
    HindFootPitch,

    /// <summary>The foremost pair of legs folded as under a body that lies on its belly: 0 as they are, 1 folded, with the feet wherever that takes them. Of an upright body on two legs both legs stretched out behind, as the trunk tips over ahead onto its chest.</summary>
    ForeFold,

    /// <summary>All other legs folded in the same way.</summary>
    HindFold,

    /// <summary>The body rolled over onto the flank of the act's side, with its legs, or onto its back where these are out to the sides: 0 on its belly, 1 where it comes to rest.</summary>
    OnFlank,

    /// <summary>The front of a body on many pairs of legs bent up off the ground with its feet, while the pairs behind it stand.</summary>
    FrontUp,

    /// <summary>The raised front of such a body bent to the act's side.</summary>
    FrontSide,

    /// <summary>What the act strikes or eats with, on its way to the target: 0 where the other channels have it, 1 there.</summary>
    Reach,
}
