using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>Gives the head its jaw and its eyes.</summary>
internal static class HeadRigger
{
    /// <summary>Segment of the mouth slit on the left flank.</summary>
    private const int SlitSegment = 10;

    /// <summary>Adds the jaw, which turns about the line through both flanks behind the lip corners, and gives its joint; −1 without a mouth.</summary>
    public static int AddJaw(SkeletonBuilder skeleton, RigInput input, int head)
    {
        MouthSeam mouth = input.Mouth;
        if (!mouth.Opens)
        {
            return -1;
        }

        BodyShape shape = input.Skin.Shape;
        Vector3 hinge = input.Skin[mouth.HingeRing, SlitSegment];
        hinge.X = 0f;

        // The chin: under the middle of the lower lip.
        Vector3 chin = input.Surface.Positions[mouth.LowerLip[mouth.LowerLip.Length / 2]] - (shape.Up(0) * (float)(shape.Bottom[0] / 2));
        chin.X = 0f;
        Vector3 direction = chin - hinge;
        int jaw = skeleton.Add(head, Side.Median, new JointDraft("Jaw", JointRole.Jaw, hinge, JointFrame.Median(direction), Vec.Length(direction), JointLimits.Body(JointRole.Jaw)));
        skeleton.AddEnd(jaw, Side.Median, "JawEnd", chin);
        return jaw;
    }

    /// <summary>Adds both eyes; +Y of their joints is the gaze.</summary>
    public static void AddEyes(SkeletonBuilder skeleton, EyeSocket eye, int head)
    {
        Quaternion frame = JointFrame.Raised(eye.Gaze, -Vector3.UnitY);
        JointDraft[] left =
        {
            new("Eye_L", JointRole.Eye, eye.Centre, frame, eye.Radius, JointLimits.Body(JointRole.Eye)),
            new("Eye_L_End", JointRole.End, eye.Centre + (eye.Gaze * eye.Radius), frame, 0f, JointLimit.Fixed),
        };
        skeleton.AddPair(head, left, new[] { "Eye_R", "Eye_R_End" });
    }
}
