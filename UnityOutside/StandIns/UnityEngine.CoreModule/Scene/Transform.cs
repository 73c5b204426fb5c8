namespace UnityEngine;

/// <summary>A place that its parents do not move: the matrix is set by whoever tests.</summary>
public class Transform : Component
{
    public Matrix4x4 localToWorldMatrix { get; internal set; } = Matrix4x4.identity;

    public Vector3 position
    {
        get => new Vector3(localToWorldMatrix.m03, localToWorldMatrix.m13, localToWorldMatrix.m23);
        set
        {
            var moved = localToWorldMatrix;
            (moved.m03, moved.m13, moved.m23) = (value.x, value.y, value.z);
            localToWorldMatrix = moved;
        }
    }

    /// <summary>Of what has turned with its parent so far.</summary>
    public Vector3 localPosition
    {
        get => Parent is null ? position : Parent.localToWorldMatrix.inverse.MultiplyPoint3x4(position);
        set => position = Parent is null ? value : Parent.localToWorldMatrix.MultiplyPoint3x4(value);
    }

    public Vector3 localScale
    {
        get => new Vector3(((Vector3)localToWorldMatrix.GetColumn(0)).magnitude,
            ((Vector3)localToWorldMatrix.GetColumn(1)).magnitude, ((Vector3)localToWorldMatrix.GetColumn(2)).magnitude);
        set => Place(position, value, Axis(0), Axis(1), Axis(2));
    }

    public void SetPositionAndRotation(Vector3 position, Quaternion rotation) =>
        Place(position, localScale, rotation * Vector3.right, rotation * Vector3.up, rotation * Vector3.forward);

    Vector3 Axis(int axis) => ((Vector3)localToWorldMatrix.GetColumn(axis)).normalized;

    void Place(Vector3 position, Vector3 scale, Vector3 x, Vector3 y, Vector3 z)
    {
        (x, y, z) = (x * scale.x, y * scale.y, z * scale.z);
        localToWorldMatrix = new Matrix4x4(new Vector4(x.x, x.y, x.z, 0), new Vector4(y.x, y.y, y.z, 0),
            new Vector4(z.x, z.y, z.z, 0), new Vector4(position.x, position.y, position.z, 1));
    }

    public Transform parent => Parent;

    internal Transform Parent { get; private set; }
    internal List<Transform> Children { get; } = new List<Transform>();

    /// <summary>The parent is remembered, and moves it no more.</summary>
    public void SetParent(Transform parent, bool worldPositionStays)
    {
        if (!worldPositionStays && Parent is not null)
            localToWorldMatrix = Parent.localToWorldMatrix.inverse * localToWorldMatrix;
        if (!worldPositionStays && parent is not null)
            localToWorldMatrix = parent.localToWorldMatrix * localToWorldMatrix;
        Leave();
        Parent = parent;
        parent?.Children.Add(this);
        gameObject.Refresh();
    }

    List<Transform> Siblings => Parent?.Children ??
        SceneLoop.Objects.Where(o => o.transform.Parent is null && o.scene == gameObject.scene).Select(o => o.transform).ToList();

    public int GetSiblingIndex() => Siblings.IndexOf(this);

    /// <summary>Behind the last one it is the last.</summary>
    public void SetSiblingIndex(int index)
    {
        var siblings = Siblings;
        siblings.Remove(this);
        siblings.Insert(Math.Min(index, siblings.Count), this);
        if (Parent is not null)
            return;
        foreach (var root in siblings)
            SceneLoop.Objects.Remove(root.gameObject);
        SceneLoop.Objects.AddRange(siblings.Select(s => s.gameObject));
    }

    internal void Leave()
    {
        Parent?.Children.Remove(this);
        Parent = null;
    }
}
