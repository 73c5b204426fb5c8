namespace UnityEngine.Rendering;

// SetInstanceMultiplier: A is the number.
// Draws: X is the material, Y the sheet of the property block, Z the arguments; A the pass, B the topology, C the vertices
// (indirect: where the arguments begin, in bytes), D the instances; Data the object's matrix.
public partial class CommandBuffer
{
    public void DrawProcedural(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int vertexCount) =>
        DrawProcedural(matrix, material, shaderPass, topology, vertexCount, 1);

    public void DrawProcedural(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int vertexCount,
        int instanceCount) => DrawProcedural(matrix, material, shaderPass, topology, vertexCount, instanceCount, null);

    /// <param name="properties">Counts as it is at this call.</param>
    public void DrawProcedural(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int vertexCount,
        int instanceCount, MaterialPropertyBlock properties)
    {
        CheckMaterial(material);
        Add(new RecordedCommand
        {
            Kind = CommandKind.Draw,
            X = material,
            Y = AddSheet(properties),
            A = shaderPass,
            B = (int)topology,
            C = vertexCount,
            D = instanceCount,
            Data = AddValue(PropertyValue.Of(matrix)),
        });
    }

    public void DrawProceduralIndirect(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology,
        GraphicsBuffer bufferWithArgs) => DrawProceduralIndirect(matrix, material, shaderPass, topology, bufferWithArgs, 0);

    public void DrawProceduralIndirect(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology,
        GraphicsBuffer bufferWithArgs, int argsOffset) =>
        DrawProceduralIndirect(matrix, material, shaderPass, topology, bufferWithArgs, argsOffset, null);

    /// <param name="argsOffset">Where the GraphicsBuffer.IndirectDrawArgs begin, in bytes.</param>
    public void DrawProceduralIndirect(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology,
        GraphicsBuffer bufferWithArgs, int argsOffset, MaterialPropertyBlock properties) =>
        AddIndirect(null, matrix, material, shaderPass, topology, bufferWithArgs, argsOffset, properties);

    /// <param name="argsOffset">Where the GraphicsBuffer.IndirectDrawIndexedArgs begin, in bytes.</param>
    public void DrawProceduralIndirect(GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass,
        MeshTopology topology, GraphicsBuffer bufferWithArgs, int argsOffset, MaterialPropertyBlock properties)
    {
        if (indexBuffer == null)
            throw new ArgumentNullException(nameof(indexBuffer));
        AddIndirect(indexBuffer, matrix, material, shaderPass, topology, bufferWithArgs, argsOffset, properties);
    }

    void AddIndirect(GraphicsBuffer indices, in Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology,
        GraphicsBuffer bufferWithArgs, int argsOffset, MaterialPropertyBlock properties)
    {
        CheckMaterial(material);
        if (bufferWithArgs == null)
            throw new ArgumentNullException(nameof(bufferWithArgs));
        Add(new RecordedCommand
        {
            Kind = CommandKind.DrawIndirect,
            X = material,
            Y = AddSheet(properties),
            Z = bufferWithArgs,
            Indices = indices,
            A = shaderPass,
            B = (int)topology,
            C = argsOffset,
            Data = AddValue(PropertyValue.Of(matrix)),
        });
    }

    /// <summary>Draws have so many times the instances from here on; indirect ones are left as they are.</summary>
    public void SetInstanceMultiplier(uint multiplier) =>
        Add(new RecordedCommand { Kind = CommandKind.SetInstanceMultiplier, A = (int)multiplier });

    static void CheckMaterial(Material material)
    {
        if (material == null)
            throw new ArgumentNullException(nameof(material));
    }
}
