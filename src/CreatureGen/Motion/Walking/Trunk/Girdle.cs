using CreatureGen.Anatomy;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>Fore-aft places and loads of a left and a right foot, leg lengths.</summary>
internal struct Girdle
{
    public float Left;
    public float Right;
    public float LeftLoad;
    public float RightLoad;

    public void Add(Side side, float z, float load)
    {
        if (side == Side.Left)
        {
            Left += z;
            LeftLoad += load;
        }
        else
        {
            Right += z;
            RightLoad += load;
        }
    }
}
