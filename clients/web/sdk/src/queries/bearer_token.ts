/** HTTP headers with the bearer token of a user; an empty token adds no header. */
export function withToken(token: string, headers: Record<string, string> = {}): Record<string, string> {
  return token === '' ? headers : { ...headers, Authorization: `Bearer ${token}` };
}
