namespace CreatureGen.Anatomy;

/// <summary>The rings of the <see cref="BodyGrid"/> that have a name: the stations at which body tables give numbers, and where the rooms of the body meet. The same ring is the same place of every body.</summary>
internal static class StationRing
{
    /// <summary>The front of the nose.</summary>
    public const int Nose = 0;

    /// <summary>Just behind the front of the nose, where nostrils are and the mouth ends.</summary>
    public const int Nostrils = 1;

    /// <summary>The front of the muzzle.</summary>
    public const int MuzzleFront = 2;

    /// <summary>The middle of the muzzle, where teeth are measured.</summary>
    public const int MuzzleMiddle = 4;

    /// <summary>The step from the muzzle up to the brow.</summary>
    public const int Stop = 7;

    /// <summary>The brow, where the eyes are.</summary>
    public const int Brow = 10;

    /// <summary>The widest of the skull: ears, horns and tufts are measured by it.</summary>
    public const int Cranium = 13;

    /// <summary>The last ring of the head: behind it is neck.</summary>
    public const int Nape = 16;

    /// <summary>The middle of the neck.</summary>
    public const int NeckMiddle = 19;

    /// <summary>The first ring of the trunk, behind the middle of the neck: what shapes heads ends before it, what shapes trunks begins.</summary>
    public const int TrunkFirst = 20;

    /// <summary>The base of the neck, the first ring of the torso.</summary>
    public const int NeckBase = 22;

    /// <summary>The front edge of the root of a wing that is folded along the flank.</summary>
    public const int WingRoot = 25;

    /// <summary>The shoulder.</summary>
    public const int Shoulder = 26;

    /// <summary>The ribs.</summary>
    public const int Ribs = 30;

    /// <summary>The belly.</summary>
    public const int Belly = 34;

    /// <summary>The hips of a trunk that two legs carry level.</summary>
    public const int BipedHip = 36;

    /// <summary>The loin.</summary>
    public const int Loin = 38;

    /// <summary>The hips of a trunk that stands upright.</summary>
    public const int UprightHip = 40;

    /// <summary>The pelvis.</summary>
    public const int Pelvis = 42;

    /// <summary>The last ring of the torso, where the tail leaves the rump: from here on outlines and colours are the tail's own.</summary>
    public const int TorsoLast = 44;

    /// <summary>The base of the tail.</summary>
    public const int TailBase = 45;

    /// <summary>The first ring that is tail alone: nothing that shapes the trunk reaches it, and fins and fans begin.</summary>
    public const int TailFirst = 46;

    /// <summary>Where a tail has left its root: a swimmer's is thin from here on.</summary>
    public const int TailStem = 47;

    /// <summary>A third along the tail.</summary>
    public const int TailThird = 48;

    /// <summary>Two thirds along the tail.</summary>
    public const int TailTwoThirds = 51;

    /// <summary>The tip of the tail, the last ring.</summary>
    public const int TailTip = 54;
}
