namespace CreatureGen.Motion;

/// <summary>A course and what was measured on it.</summary>
/// <param name="Course">The course.</param>
/// <param name="Report">The figures.</param>
public sealed record CourseRun(MotionCourse Course, CourseReport Report);
