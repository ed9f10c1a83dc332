namespace CreatureGen.Events;

/// <summary>How the turning of a bone is measured.</summary>
public enum AngularMeasure
{
    /// <summary>As rotation vectors between poses, the shorter way, and their change as a vector: it sees every reversal and knows no gimbal lock.</summary>
    Quaternion,

    /// <summary>As the change of each Euler angle, and the change of their sum of squares, as in the rule's first form. Kept for comparison: near gimbal lock it reports turns that are none.</summary>
    Euler,
}

/// <summary>In what space the turning of a bone is measured.</summary>
public enum AngularSpace
{
    /// <summary>In its parent's: how the joint bends.</summary>
    Parent,

    /// <summary>In the model: how the bone turns in the world of a creature that goes straight on. A foot on the ground does not turn there.</summary>
    Model,
}

/// <summary>Which changes of turning count.</summary>
public enum AngularChange
{
    /// <summary>All.</summary>
    Any,

    /// <summary>Those by which the bone turns more slowly than before: it is stopped.</summary>
    Slowing,

    /// <summary>Those by which it turns faster than before.</summary>
    Quickening,
}

/// <summary>Which of several moments in an interval stays.</summary>
public enum IntervalWinner
{
    /// <summary>The first, as in the rule's first form.</summary>
    Earliest,

    /// <summary>The one of the greatest acceleration.</summary>
    Strongest,
}

/// <summary>Whose moments shut one another out.</summary>
public enum IntervalScope
{
    /// <summary>Those of all joints.</summary>
    Together,

    /// <summary>Those of one joint.</summary>
    EachJoint,
}

/// <summary>Which peak of a stretch above the threshold is its moment.</summary>
public enum AngularPeak
{
    /// <summary>The highest, as in the rule's first form.</summary>
    Highest,

    /// <summary>The last that is at least half as high as the highest: what ends a movement.</summary>
    Last,
}
