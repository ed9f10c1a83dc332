namespace CreatureGen.Motion.Metrics;

/// <summary>What a course goes over. Lengths are in leg lengths of who goes over it.</summary>
public enum CourseGround
{
    /// <summary>The plane y = 0.</summary>
    Flat,

    /// <summary>Smooth seeded hills of the lengths and heights of <see cref="HillField"/>, without end.</summary>
    Rough,

    /// <summary>Flights of stairs up and down across the Z axis, treads of 0.55 and rises of 0.2, as a mesh.</summary>
    Stairs,

    /// <summary>A platform without edges that rises, sinks, slides and turns.</summary>
    Lift,

    /// <summary>Ramps of 20° up and down across the Z axis with level ground between, as a mesh.</summary>
    Slope,

    /// <summary>Level ground with gaps of 0.4 across the Z axis, one every 2.2, as a mesh.</summary>
    Gap,

    /// <summary>Blocks 0.35 high and 4 long across the Z axis, to be stepped onto and off, as a mesh.</summary>
    Platform,

    /// <summary>Lakes across the Z axis with shores of 20°, too deep to stand in, and islands between, as a mesh under a level surface.</summary>
    Water,

    /// <summary>Stepping stones in rows without end, 0.5 wide and long, one every 0.72, with seeded heights and places and nothing between.</summary>
    Stones,

    /// <summary>The inside of a pipe along the X axis, 12 in radius: who goes ahead goes up its wall and along its ceiling, where up is towards the axis.</summary>
    Pipe,
}
