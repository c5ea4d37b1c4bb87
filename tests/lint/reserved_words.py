# SPDX-License-Identifier: Apache-2.0
"""Words that a target of the shading text reserves, so that no name of the text may be one of them.

Excepted, because the translator of the one target renames them: `color` and the shader globals
`u`, `v`, `N`, `P` of OSL."""

_LISTS = {
    "C and C++": """
        alignas alignof and and_eq asm auto bitand bitor bool break case catch char class compl
        concept const_cast consteval constexpr constinit continue co_await co_return co_yield
        decltype default delete dynamic_cast enum explicit export extern false friend goto long
        mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public
        register reinterpret_cast requires restrict short signed sizeof static_assert static_cast
        template this thread_local throw true try typeid typename union using virtual volatile
        wchar_t xor xor_eq complex imaginary I""",
    "Windows headers (macros)": "near far small min max",
    "GLSL": """
        active atomic_uint attribute bvec2 bvec3 bvec4 buffer cast centroid coherent common
        discard dmat2 dmat3 dmat4 dvec2 dvec3 dvec4 external filter fixed flat fvec2 fvec3 fvec4
        half highp hvec2 hvec3 hvec4 in inout input interface invariant ivec2 ivec3 ivec4 layout
        lowp mat2 mat3 mat4 mediump noinline noperspective out output packed partition patch
        precise precision readonly resource sample sampler2D sampler3D samplerCube shared smooth
        subroutine superp uint uniform uvec2 uvec3 uvec4 varying vec2 vec4 writeonly main""",
    "HLSL": """
        AppendStructuredBuffer BlendState Buffer ByteAddressBuffer cbuffer column_major compile
        compile_fragment ComputeShader ConsumeStructuredBuffer DepthStencilState DomainShader dword
        float1 float2 float3 float4 fxgroup GeometryShader groupshared Hullshader InputPatch
        int2 int3 int4 line lineadj linear LineStream matrix min10float min16float min16int
        min16uint nointerpolation OutputPatch packoffset pass pixelfragment PixelShader point
        PointStream RasterizerState register row_major RWBuffer RWTexture2D sampler SamplerState
        snorm stateblock stateblock_state string StructuredBuffer tbuffer technique technique10
        technique11 texture Texture1D Texture2D Texture3D TextureCube triangle triangleadj
        TriangleStream unorm vector vertexfragment VertexShader""",
    "MSL": """
        constant device fragment half2 half3 half4 kernel thread threadgroup threadgroup_imageblock
        vertex visible ushort uchar ulong uint2 uint3 uint4 metal texture2d access depth2d simd""",
    "WGSL": """
        NULL Self abstract alias array as asm_fragment async atomic await become bitcast
        const_assert continuing crate debugger demote demote_to_helper diagnostic enable extends
        f16 f32 fallthrough final finally fn from get i32 impl implements import instanceof let
        loop macro macro_rules match meta mod module move mut nil non_coherent noncoherent null
        of override package premerge priv ptr pub ref regardless require self set std super
        target trait type typedef typeof u32 unless unsafe unsized use var vec2f vec3f vec4f
        where wgsl with yield""",
    "OSL": """
        closure emit normal surface shader displacement volume illuminance illuminate public Ci Ng
        Ps dPdu dPdv dPdtime dtime time""",
}

RESERVED = {word: target for target, words in _LISTS.items() for word in words.split()}

# Functions of GLSL, HLSL, MSL, WGSL or OSL that a function of the text may not be named after:
# GLSL ES refuses it, and elsewhere calls become ambiguous. Variables may have these names.
BUILTINS = set("""
    abs acos acosh all any asin asinh atan atan2 atanh ceil clamp cos cosh cross degrees determinant
    distance dot equal exp exp2 faceforward floor floatBitsToInt floatBitsToUint fma fract frac
    frexp fwidth intBitsToFloat inverse inversesqrt isinf isnan isfinite ldexp length lerp log log2
    log10 max min mix mod modf normalize outerProduct pow powr radians reflect refract round rsqrt
    saturate select sign sin sincos sinh smoothstep sqrt step tan tanh texture transpose trunc
    uintBitsToFloat luminance blackbody fresnel noise bsdf diffuse phong ward microfacet reflection
    refraction emission background holdout transparent hypot cbrt erf erfc expm1 logb""".split())
