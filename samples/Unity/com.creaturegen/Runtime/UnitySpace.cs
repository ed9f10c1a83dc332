using CreatureGen.Engines;
using UnityEngine;

namespace CreatureGen.Unity
{
    /// <summary>Between the library's space (right-handed, +X to the left) and Unity's. Both have metres, +Y up and +Z ahead, so that each conversion is its own inverse.</summary>
    public static class UnitySpace
    {
        public static Vector3 Point(System.Numerics.Vector3 v) => new Vector3(-v.X, v.Y, v.Z);

        public static System.Numerics.Vector3 Point(Vector3 v) => new System.Numerics.Vector3(-v.x, v.y, v.z);

        public static Quaternion Rotation(System.Numerics.Quaternion q) => new Quaternion(q.X, -q.Y, -q.Z, q.W);

        public static System.Numerics.Quaternion Rotation(Quaternion q) => new System.Numerics.Quaternion(q.x, -q.y, -q.z, q.w);

        /// <summary>A matrix whose floats <see cref="EngineAxes.Unity"/> has put in Unity's order: its rows are Unity's columns.</summary>
        public static Matrix4x4 Matrix(in System.Numerics.Matrix4x4 m)
        {
            var result = new Matrix4x4();
            result.SetColumn(0, new Vector4(m.M11, m.M12, m.M13, m.M14));
            result.SetColumn(1, new Vector4(m.M21, m.M22, m.M23, m.M24));
            result.SetColumn(2, new Vector4(m.M31, m.M32, m.M33, m.M34));
            result.SetColumn(3, new Vector4(m.M41, m.M42, m.M43, m.M44));
            return result;
        }
    }
}
