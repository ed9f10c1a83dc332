using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Chains;

/// <summary>A limb and its mirror image, both described on the left.</summary>
internal sealed class PairedChain
{
    private readonly JointRotation[] left;
    private readonly JointRotation[] right;
    private readonly Vector3[] points;
    private readonly Vector3[] axes;
    private readonly Skeleton skeleton;

    private PairedChain(Skeleton skeleton, LimbChain limb, JointRotation[] left, JointRotation[] right, Vector3[] points)
    {
        this.skeleton = skeleton;
        Limb = limb;
        this.left = left;
        this.right = right;
        this.points = points;
        axes = new Vector3[left.Length];
        for (int k = 0; k < axes.Length; k++)
        {
            axes[k] = Vec.Normalize(points[k + 1] - points[k], Vector3.UnitX);
        }
    }

    /// <summary>The left limb.</summary>
    public LimbChain Limb { get; }

    /// <summary>Number of joints that turn.</summary>
    public int Count => left.Length;

    /// <summary>A joint that turns, of the left limb.</summary>
    /// <param name="k">0 up to their number.</param>
    public int JointAt(int k) => left[k].Joint;

    /// <summary>Rest positions of the joints and the end, left, model space.</summary>
    public System.ReadOnlySpan<Vector3> Points => points;

    /// <summary>Rest directions of the bones, left, model space, unit.</summary>
    public System.ReadOnlySpan<Vector3> Axes => axes;

    /// <summary>Length of its bones in all, metres.</summary>
    public double Reach
    {
        get
        {
            double reach = 0;
            for (int k = 0; k < axes.Length; k++)
            {
                reach += Vec.Distance(points[k], points[k + 1]);
            }

            return reach;
        }
    }

    /// <summary>The pair of a left limb; null when it has no counterpart.</summary>
    public static PairedChain? Of(Skeleton skeleton, LimbChain limb)
    {
        if (limb.Side != Side.Left)
        {
            return null;
        }

        int count = limb.Joints.Count - 1;
        var left = new JointRotation[count];
        var right = new JointRotation[count];
        var points = new Vector3[count + 1];
        for (int k = 0; k <= count; k++)
        {
            int joint = limb.Joints[k];
            points[k] = skeleton.ModelPositions[joint];
            if (k == count)
            {
                break;
            }

            if (skeleton.Mirrors[joint] == joint)
            {
                return null;
            }

            left[k] = new JointRotation(skeleton, joint);
            right[k] = new JointRotation(skeleton, skeleton.Mirrors[joint]);
        }

        return new PairedChain(skeleton, limb, left, right, points);
    }

    /// <summary>Writes a joint; the turn is that of the left limb, of which the right one takes the mirror image.</summary>
    public void Write(in Pose local, Side side, int joint, Quaternion turn)
    {
        if (side == Side.Left)
        {
            left[joint].Write(local, turn);
        }
        else
        {
            right[joint].Write(local, Rotation.Mirror(turn));
        }
    }

    /// <summary>Writes a joint of both sides as it is, and at its limit where it goes beyond: for what has to reach its place.</summary>
    public void WriteFirm(in Pose local, int joint, Quaternion turn)
    {
        left[joint].WriteFirm(local, turn);
        right[joint].WriteFirm(local, Rotation.Mirror(turn));
    }

    /// <summary>Draws a joint of both sides towards the one before it.</summary>
    /// <param name="local">Receives its place.</param>
    /// <param name="joint">Place in the chain.</param>
    /// <param name="fraction">Of the bone's length that is left.</param>
    public void Draw(in Pose local, int joint, float fraction)
    {
        int near = left[joint].Joint;
        int far = right[joint].Joint;
        local.Positions[near] = skeleton.LocalPositions[near] * fraction;
        local.Positions[far] = skeleton.LocalPositions[far] * fraction;
    }

    /// <summary>The turn that the limits leave of a turn of the left limb.</summary>
    public Quaternion Limit(int joint, Quaternion turn) => left[joint].Limit(turn);

    /// <summary>A turn of a bone that lies out to the left: it is twisted about itself (positive: leading edge down), swept back, then raised.</summary>
    public Quaternion Stroke(int joint, double raise, double sweep, double twist) =>
        Rotation.Multiply(AxisRotation.Roll(raise), Rotation.Multiply(AxisRotation.Yaw(sweep), Rotation.FromAxisAngle(axes[joint], twist)));
}
