namespace CreatureGen.Motion.Grounds;

/// <summary>Lets a game's ground in, by the gate for what it can do: that is asked once for as long as the ground stays the same.</summary>
internal sealed class GroundGate
{
    private readonly CheckedGround still = new();
    private readonly CheckedMovingGround moving = new();
    private readonly CheckedPlaneGround plane = new();
    private CheckedGround gate;
    private IGround? ground;

    public GroundGate() => gate = still;

    /// <summary>Hits that counted as none since the ground was let in last.</summary>
    public int Refused => gate.Refused;

    /// <summary>Lets a ground in for one update.</summary>
    public CheckedGround Open(IGround given)
    {
        if (ReferenceEquals(given, ground))
        {
            gate.BeginAgain();
            return gate;
        }

        ground = given;
        switch (given)
        {
            case IMovingGround platforms:
                moving.Begin(platforms);
                return gate = moving;
            case IPlaneGround even:
                plane.Begin(even);
                return gate = plane;
            default:
                still.Begin(given);
                return gate = still;
        }
    }
}
